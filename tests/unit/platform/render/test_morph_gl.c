/* test_morph_gl.c -- Compares the fish shapes that the vertex shaders compute or read with those of
 * morph_shape() on the CPU.
 *
 * The test covers every built-in species, both levels of detail, every key shape, nine ages between
 * two key shapes, and all kinds of morph graphs. OpenGL's transform feedback returns the vertices
 * of the shader. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include <SDL.h>

#include "platform/render/fish_mesh.h"
#include "platform/render/fish_shapes.h"
#include "platform/render/textures.h"
#include "platform/render/gl_util.h"
#include "shaders.h"
#include "tests/unit/support/gl_context.h"

#define BETWEEN 9u
#define ERROR_MAX 1e-5f  /* Largest allowed position error, in body lengths. */
#define NORMAL_MAX 1e-3f /* Largest allowed length of the difference of two unit normals. */
/* Row of the shape table that the shader must read. A row other than 0 is used, so that a shader
 * that ignores the row number is detected. */
#define ROW 7u
/* Largest allowed errors of a shape that is stored as 16-bit floats. Coordinates are below 1 body
 * length, where two neighbouring 16-bit floats differ by at most 0.0005. */
#define HALF_ERROR_MAX 5e-4f
#define HALF_NORMAL_MAX 1e-3f

struct vertex {
    float position[3], normal[3];
};

struct rig_case {
    const char *name;
    uint8_t template_id, thesis;
};

static const struct rig_case rig_cases[] = {
    { "own", TEMPLATE_OWN, 0 },
    { "pairwise", TEMPLATE_PAIRWISE, 0 },
    { "simultaneous", TEMPLATE_SIMULTANEOUS, 0 },
    { "thesis", TEMPLATE_OWN, 1 },
};

static const char vertex_main[] = "out vec3 position;\n"
                                  "out vec3 normal;\n"
                                  "void main()\n"
                                  "{\n"
                                  "    morph(position, normal);\n"
                                  "    normal = normalize(normal);\n"
                                  "    gl_Position = vec4(position, 1.0);\n"
                                  "}\n";
/* The code with which fish.vert.glsl reads the shape of a fish. */
static const char shapes_main[] =
    "uniform sampler2D shapes;\n"
    "uniform int row;\n"
    "out vec3 position;\n"
    "out vec3 normal;\n"
    "void main()\n"
    "{\n"
    "    ivec2 texel = ivec2(2 * gl_VertexID, row);\n"
    "    position = texelFetch(shapes, texel, 0).xyz;\n"
    "    normal = normalize(texelFetch(shapes, texel + ivec2(1, 0), 0).xyz);\n"
    "    gl_Position = vec4(position, 1.0);\n"
    "}\n";
static const char fragment_main[] = "out vec4 color;\nvoid main() { color = vec4(1.0); }\n";

static struct gl_status status;
static struct fish_mesh mesh;
static struct fish_mesh_memory memory;
static struct fish_shapes shapes;
static struct morph_pose pose;
static struct morph_rig rig;
static struct straight_memory straight;
static struct species thesis;
static float texels[POSE_TEXELS_MAX][4];
static GLuint pose_buffer, feedback_buffer;
static vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];

static int open_context(void **state)
{
    (void)state;
    open_gl_context("morph");
    fish_mesh_reserve(&mesh);
    pose_buffer = gl_buffer(GL_UNIFORM_BUFFER, NULL, sizeof texels);
    feedback_buffer =
        gl_buffer(GL_TRANSFORM_FEEDBACK_BUFFER, NULL, MESH_VERTEX_MAX * sizeof(struct vertex));
    return 0;
}

static GLuint program(const char *defines, const char *vertex_source)
{
    static const char *const captured[2] = { "position", "normal" };
    const char *const vertex_parts[] = { "#version 300 es\n", defines, shader_common, shader_morph,
                                         vertex_source };
    const char *const fragment_parts[] = { "#version 300 es\nprecision highp float;\n",
                                           fragment_main };
    const GLuint vertex = gl_compile(&status, "morph", GL_VERTEX_SHADER, vertex_parts, 5);
    const GLuint fragment = gl_compile(&status, "morph", GL_FRAGMENT_SHADER, fragment_parts, 2);
    const GLuint made = glCreateProgram();
    glAttachShader(made, vertex);
    glAttachShader(made, fragment);
    glTransformFeedbackVaryings(made, 2, captured, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(made);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    assert_string_equal(status.text, "");
    gl_program_bind(made, "shapes");
    return made;
}

/* Runs the current shader program for every vertex of the mesh. Returns the results as a mapped
 * buffer, which the caller must unmap. */
static const struct vertex *capture(uint32_t vertex_count)
{
    const GLsizeiptr size = (GLsizeiptr)(vertex_count * sizeof(struct vertex));
    glBindVertexArray(mesh.vertex_array);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, feedback_buffer);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, (GLsizei)vertex_count);
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glBindVertexArray(0);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    return glMapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, size, GL_MAP_READ_BIT);
}

struct error {
    float position, normal;
};

static float distance(const float a[3], vec3 b)
{
    return v3_length(v3_sub(v3(a[0], a[1], a[2]), b));
}

/* Returns the largest differences between the shader's vertices and those of morph_shape(). Both
 * use the same `pose`. */
static struct error compare(const struct species_mesh *source, uint32_t key_count)
{
    struct error error = { 0.0f, 0.0f };
    const struct vertex *const seen = capture(source->vertex_count);
    assert_non_null(seen);
    morph_shape(source, key_count, &pose, positions, normals);
    for (uint32_t i = 0; i < source->vertex_count; i++) {
        error.position = f_max(error.position, distance(seen[i].position, positions[i]));
        error.normal = f_max(error.normal, distance(seen[i].normal, normals[i]));
    }
    glUnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
    return error;
}

static void send_block(uint32_t anchor_count)
{
    fish_poses_pack(texels, &pose, MORPH_CURVE_MAX, anchor_count);
    glBindBuffer(GL_UNIFORM_BUFFER, pose_buffer);
    gl_buffer_refill(GL_UNIFORM_BUFFER, texels, sizeof texels);
    glBindBufferBase(GL_UNIFORM_BUFFER, 1, pose_buffer);
}

static void use(GLuint name, const struct species_mesh *source)
{
    glUseProgram(name);
    glUniform1f(glGetUniformLocation(name, "reach"), source->reach);
}

static void worse(struct error *worst, struct error error)
{
    worst->position = f_max(worst->position, error.position);
    worst->normal = f_max(worst->normal, error.normal);
}

/* Compares one mesh at all ages. */
static struct error follow(const struct species *species, uint32_t lod, GLuint name)
{
    struct error worst = { 0.0f, 0.0f };
    const struct species_mesh *const source = &species->lod[lod];
    const uint32_t steps = (species->card.key_count - 1u) * (BETWEEN + 1u);
    fish_mesh_fill(&mesh, &memory, source, species->card.key_count);
    use(name, source);
    for (uint32_t step = 0; step <= steps; step++) {
        morph_pose(&rig, source, (float)step / (float)steps, &pose);
        send_block(source->anchor_count);
        worse(&worst, compare(source, species->card.key_count));
    }
    return worst;
}

static const struct species *species_of(const struct rig_case *of, uint32_t index)
{
    if (of->thesis) {
        straight_thesis(species_table[index], &straight, &thesis);
        return &thesis;
    }
    return species_table[index];
}

static void test_a_uniform_block_for_one_fish_gives_the_shape_of_the_cpu(void **state)
{
    (void)state;
    struct error worst = { 0.0f, 0.0f };
    const GLuint name =
        program("#define KEYS 8\n#define CURVES 4\n#define ANCHORS 2\n", vertex_main);
    for (uint32_t i = 0; i < species_table_count; i++) {
        for (size_t k = 0; k < sizeof rig_cases / sizeof *rig_cases; k++) {
            const struct species *const species = species_of(&rig_cases[k], i);
            morph_rig_init(&rig, &species->card, (enum graph_template)rig_cases[k].template_id);
            for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
                const struct error error = follow(species, lod, name);
                print_message("%-10s %-12s lod %u: %.1e of a length, normals %.1e\n",
                              species_table[i]->card.id, rig_cases[k].name, lod,
                              (double)error.position, (double)error.normal);
                worse(&worst, error);
            }
        }
    }
    glDeleteProgram(name);
    print_message("worst: %.2e of a length, normals %.2e\n", (double)worst.position,
                  (double)worst.normal);
    assert_true(worst.position <= ERROR_MAX);
    assert_true(worst.normal <= NORMAL_MAX);
}

/* The wakin (a goldfish) at all ages, as the tank draws its fish. */
static void test_a_texture_row_for_each_fish_gives_the_shape_of_the_cpu(void **state)
{
    (void)state;
    struct error worst = { 0.0f, 0.0f };
    const struct species *const species = &species_wakin;
    const GLuint name = program("", shapes_main);
    morph_rig_init(&rig, &species->card, TEMPLATE_OWN);
    glUseProgram(name);
    glUniform1i(glGetUniformLocation(name, "row"), (GLint)ROW);
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        const struct species_mesh *const source = &species->lod[lod];
        fish_shapes_open(&status, &shapes, source);
        for (uint32_t step = 0; step <= 40u; step++) {
            const float progress = (float)step / 40.0f;
            fish_shapes_begin(&shapes);
            fish_shapes_set(&shapes, &rig, source, ROW, progress);
            fish_shapes_end(&shapes);
            morph_pose(&rig, source, progress, &pose);
            worse(&worst, compare(source, species->card.key_count));
        }
        fish_shapes_close(&shapes);
    }
    glDeleteProgram(name);
    print_message("worst: %.2e of a length, normals %.2e\n", (double)worst.position,
                  (double)worst.normal);
    assert_true(worst.position <= HALF_ERROR_MAX);
    assert_true(worst.normal <= HALF_NORMAL_MAX);
}

/* The shader supports eight key shapes, but no built-in species has more than five. The test makes
 * eight keys from those of the wakin (a goldfish), and shifts each key by a different amount. An
 * error in the data of any key thus changes the shape. */
static void test_eight_keys_are_blended_each_by_its_own_weight(void **state)
{
    (void)state;
    static struct species_point moved[MORPH_KEY_MAX][MESH_VERTEX_MAX];
    const struct species *const species = species_table[0];
    struct species_mesh eight = species->lod[0];
    for (uint32_t key = 0; key < MORPH_KEY_MAX; key++) {
        const uint32_t from = key % species->card.key_count;
        for (uint32_t i = 0; i < eight.vertex_count; i++) {
            moved[key][i] = species->lod[0].points[from][i];
            moved[key][i].x = (int16_t)(moved[key][i].x / 2 + 900 * (int32_t)key);
            moved[key][i].y = (int16_t)(moved[key][i].y / 2 - 700 * (int32_t)key);
        }
        eight.points[key] = moved[key];
    }
    eight.anchor_count = 0; /* The anchors of the mesh belong to its five original key shapes, so
                               the test removes them. */
    static struct species_vertex free[MESH_VERTEX_MAX];
    for (uint32_t i = 0; i < eight.vertex_count; i++) {
        free[i] = eight.vertices[i];
        free[i].anchor = ANCHOR_NONE;
    }
    eight.vertices = free;
    const GLuint name =
        program("#define KEYS 8\n#define CURVES 4\n#define ANCHORS 2\n", vertex_main);
    fish_mesh_fill(&mesh, &memory, &eight, MORPH_KEY_MAX);
    use(name, &eight);
    for (uint32_t key = 0; key < MORPH_KEY_MAX; key++) {
        memset(&pose, 0, sizeof pose);
        for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
            pose.weight[curve][key] = 0.75f;
            pose.weight[curve][(key + 3u) % MORPH_KEY_MAX] = 0.25f;
        }
        send_block(0);
        const struct error error = compare(&eight, MORPH_KEY_MAX);
        assert_true(error.position <= ERROR_MAX);
        assert_true(error.normal <= NORMAL_MAX);
    }
    glDeleteProgram(name);
}

/* Rounds the weights to eight bits. The position error must then exceed ERROR_MAX. This proves that
 * the comparisons above detect such small errors. */
static void test_the_test_detects_weights_of_eight_bits(void **state)
{
    (void)state;
    const struct species *const species = species_table[0];
    const GLuint name =
        program("#define KEYS 8\n#define CURVES 4\n#define ANCHORS 2\n", vertex_main);
    fish_mesh_fill(&mesh, &memory, &species->lod[0], species->card.key_count);
    use(name, &species->lod[0]);
    morph_rig_init(&rig, &species->card, TEMPLATE_PAIRWISE);
    morph_pose(&rig, &species->lod[0], 0.33f, &pose);
    const struct morph_pose exact = pose;
    for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
        for (uint32_t key = 0; key < MORPH_KEY_MAX; key++) {
            pose.weight[curve][key] = f_floor(pose.weight[curve][key] * 255.0f + 0.5f) / 255.0f;
        }
    }
    send_block(species->lod[0].anchor_count);
    pose = exact;
    assert_true(compare(&species->lod[0], species->card.key_count).position > ERROR_MAX);
    glDeleteProgram(name);
}

static void test_the_test_detects_an_anchor_error_of_a_thousandth(void **state)
{
    (void)state;
    const struct species *const species = species_table[0];
    const GLuint name =
        program("#define KEYS 8\n#define CURVES 4\n#define ANCHORS 2\n", vertex_main);
    fish_mesh_fill(&mesh, &memory, &species->lod[0], species->card.key_count);
    use(name, &species->lod[0]);
    morph_rig_init(&rig, &species->card, TEMPLATE_OWN);
    morph_pose(&rig, &species->lod[0], 0.33f, &pose);
    assert_true(species->lod[0].anchor_count > 0);
    pose.anchor[species->lod[0].anchor_count - 1u].position.x += 0.001f;
    send_block(species->lod[0].anchor_count);
    pose.anchor[species->lod[0].anchor_count - 1u].position.x -= 0.001f;
    assert_true(compare(&species->lod[0], species->card.key_count).position > ERROR_MAX);
    glDeleteProgram(name);
}

/* Returns the number of vertices that the triangles of two lists use. */
static uint32_t used_vertices(uint32_t first, uint32_t count)
{
    static bool used[MESH_VERTEX_MAX];
    uint32_t result = 0;
    memset(used, 0, sizeof used);
    for (uint32_t i = first; i < first + count; i++) {
        result += used[memory.indices[i]] ? 0u : 1u;
        used[memory.indices[i]] = true;
    }
    return result;
}

static void test_a_small_fish_has_fewer_vertices_and_each_side_of_a_fin_is_drawn_once(void **state)
{
    (void)state;
    const struct species_mesh *const source = &species_wakin.lod[1];
    fish_mesh_fill(&mesh, &memory, source, species_wakin.card.key_count);
    const GLsizei body = mesh.index_counts[FISH_BODY], fins = mesh.index_counts[FISH_FINS];
    assert_int_equal(body + fins, source->index_count);
    assert_int_equal(mesh.index_counts[FISH_SMALL_BODY], 0);
    fish_mesh_fill_tank(&mesh, &memory, source, species_wakin.card.key_count);
    assert_int_equal(mesh.index_counts[FISH_BODY], body);
    assert_int_equal(mesh.index_counts[FISH_FINS], fins / 2);
    const uint32_t first = (uint32_t)(body + fins / 2);
    const uint32_t small =
        (uint32_t)(mesh.index_counts[FISH_SMALL_BODY] + mesh.index_counts[FISH_SMALL_FINS]);
    assert_int_equal(used_vertices(0, first), source->vertex_count);
    assert_in_range(used_vertices(first, small), source->vertex_count / 3u,
                    source->vertex_count * 3u / 5u);
}

static void test_the_shape_of_a_fish_that_has_not_grown_is_not_recomputed(void **state)
{
    (void)state;
    fish_shapes_open(&status, &shapes, &species_wakin.lod[0]);
    morph_rig_init(&rig, &species_wakin.card, TEMPLATE_OWN);
    for (uint32_t frame = 0; frame < 2; frame++) {
        fish_shapes_begin(&shapes);
        for (uint32_t row = 0; row < 40; row++) {
            const float grown = row == ROW ? 0.1f * (float)frame : 0.0f;
            fish_shapes_set(&shapes, &rig, &species_wakin.lod[0], row, 0.02f * (float)row + grown);
        }
        fish_shapes_end(&shapes);
        assert_int_equal(shapes.written_count, frame == 0 ? 40 : 1);
    }
    /* Another fish of the same age takes over the row, and the fish is of another variety. */
    fish_shapes_begin(&shapes);
    fish_shapes_set(&shapes, &rig, &species_demekin.lod[0], 0, 0.0f);
    fish_shapes_set(&shapes, &rig, &species_wakin.lod[0], 1, 0.02f);
    fish_shapes_end(&shapes);
    assert_int_equal(shapes.written_count, 1);
    fish_shapes_close(&shapes);
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_texture_row_for_each_fish_gives_the_shape_of_the_cpu),
        cmocka_unit_test(test_a_uniform_block_for_one_fish_gives_the_shape_of_the_cpu),
        cmocka_unit_test(test_eight_keys_are_blended_each_by_its_own_weight),
        cmocka_unit_test(test_the_test_detects_weights_of_eight_bits),
        cmocka_unit_test(test_the_test_detects_an_anchor_error_of_a_thousandth),
        cmocka_unit_test(test_a_small_fish_has_fewer_vertices_and_each_side_of_a_fin_is_drawn_once),
        cmocka_unit_test(test_the_shape_of_a_fish_that_has_not_grown_is_not_recomputed),
    };
    return cmocka_run_group_tests(tests, open_context, NULL);
}
