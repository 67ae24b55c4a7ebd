// Put in front of every shader: precisions and the one block of figures that all passes share.
precision highp float;
precision mediump int;
precision mediump sampler2DArray;

layout(std140) uniform Frame {
    mat4 view_projection;
    vec4 eye;        // World position; w: seconds since the start, wrapped.
    vec4 tank;       // Half width, depth, half breadth, height of the rim above the water.
    vec4 screen;     // 1 / width, 1 / height of the target; z: absorption, 1 / m; w: caustic frame.
    vec4 shadow;     // World x, z to the shadow map's -1 .. 1; zw: light's drift, m per m of height.
};
