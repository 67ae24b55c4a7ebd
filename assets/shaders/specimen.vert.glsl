// A specimen, which is one fish of any species, blended (morph.glsl) and swimming in place, without
// perspective. With FIN defined the shader draws the fins, otherwise the body and the eyes.
layout(location = 9) in vec2 paint_at; // Coordinates in the sheets of the fish texture.

uniform mat3 axes;      // Matrix from the body's axes to the screen axes right, up and toward the
                        // viewer.
uniform vec3 place;     // xy: centre of the body in pixels from the top left. z: pixels per body
                        // length.
uniform vec2 screen_px;
uniform mat2 turn;  // Matrix that rotates the picture on the screen.
uniform vec2 move;
uniform vec3 swim;      // Phase, amplitude, and kind of swimming motion (enum species_motion).

out vec3 normal;        // Normal in the screen axes right, up and toward the viewer.
out vec2 paint_uv;
out vec4 skin;          // u, v, body part, and depth in the shade of the body.

const float TAIL = 0.5, EEL = 1.5, FINS = 2.5, TUNA = 3.5; // Upper limits of the kinds of swimming
                                                           // motion (enum species_motion).

// Returns the sideways displacement of the spine (x) and its slope along the body (y). t is 0 at
// the snout and 1 at the tail.
vec2 sway(float t)
{
    vec3 envelope; // Amplitude of the wave, slope of the amplitude, and wave number.
    if (swim.z < TAIL) {
        envelope = vec3(0.02 - 0.0825 * t + 0.1625 * t * t, -0.0825 + 0.325 * t, 6.45);
    } else if (swim.z < EEL) {
        envelope = vec3(0.018 + 0.060 * t * t, 0.120 * t, 10.2); // The body has 1.6 waves.
    } else if (swim.z < FINS) {
        envelope = vec3(0.022 * t * t * t, 0.066 * t * t, 4.2);  // The body is stiff and only the
                                                                 // tail moves.
    } else if (swim.z < TUNA) {
        envelope = vec3(0.004 + 0.090 * pow(t, 5.0), 0.45 * pow(t, 4.0), 5.2);
    } else {
        envelope = vec3(0.012 * t * t, 0.024 * t, 5.0);
    }
    float phase = swim.x - envelope.z * t;
    vec2 wave = vec2(sin(phase), -envelope.z * cos(phase));
    return swim.y * vec2(envelope.x * wave.x, envelope.y * wave.x + envelope.x * wave.y);
}

// Moves the wings of a ray. The wave travels backward along the disc and grows toward the edges of
// the disc.
void flap(inout vec3 p, inout vec3 n)
{
    float out_ = smoothstep(0.06, 0.50, abs(p.x));
    float phase = swim.x - 7.0 * (p.z + 0.5);
    float high = 0.085 * swim.y * out_ * out_;
    float rise = 0.34 * swim.y * out_ * sign(p.x) * step(0.06, abs(p.x));
    vec2 slope = vec2(rise * sin(phase), -7.0 * high * cos(phase));
    p.y += high * sin(phase);
    n = vec3(n.x - slope.x * n.y, n.y, n.z - slope.y * n.y);
}

// Moves the fins. A puffer swims with its dorsal and anal fins and fans with its pectoral fins. The
// fins of other fish trail slightly.
void scull(inout vec3 p, float part)
{
    float flex = surface.w;
    float sculls = swim.z > EEL && swim.z < FINS && part > 2.5 ? 1.0 : 0.22;
    p.x += flex * swim.y * 0.050 * sculls * sin(swim.x * 1.0 - 2.5 * surface.x - 1.2);
    if (part > 4.5 && part < 5.5) {
        float beat = sin(swim.x * 1.5 - 3.0 * surface.x);
        p.z += flex * swim.y * 0.022 * beat;
        p.y += flex * swim.y * 0.012 * beat;
    }
}

void main()
{
    vec3 p;
    vec3 n;
    float part = floor(surface.z * 255.0 + 0.5);
    morph(p, n);
    if (swim.z > TUNA) {
        flap(p, n);
    } else if (part > 1.5) {
        scull(p, part);
    }
    vec2 wave = sway(p.z + 0.5);
    float c = inversesqrt(1.0 + wave.y * wave.y);
    float s = wave.y * c;
    p = vec3(wave.x + p.x * c, p.y, p.z - p.x * s);
    n = vec3(n.x * c + n.z * s, n.y, n.z * c - n.x * s);
    normal = axes * n;
    paint_uv = paint_at;
    skin = vec4(surface.xy, part, 0.0);
    vec3 seen = axes * p;
    vec2 px = vec2(place.x + place.z * seen.x, place.y - place.z * seen.y);
    gl_Position = vec4(turn * (px / screen_px * vec2(2.0, -2.0) + vec2(-1.0, 1.0)) + move,
                      -0.2 * seen.z, 1.0);
}
