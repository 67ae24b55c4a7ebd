/* test_hand.c -- Tests the mesh of the hand that holds a poi and its frames, and the hand that
 * holds a fan. Also tests that no hand hides paper. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/scene_helpers.h"
#include "platform/render/display_gl.h"
#include "platform/render/pass/hand_mesh.h"
#include "tests/unit/support/display_fixture.h"

static struct shape shape;
static vec3 bones[HAND_VERTEX_MAX];

/* Distance along the handle, in ring radii, at which the player's number is drawn. */
#define NUMBER_AT 2.3f

/* Fills `shape` and `bones` with the mesh of a hand. */
static void build_hand(void)
{
    shape.vertex_count = shape.index_count = 0;
    hand_mesh(&shape, bones);
}

static void test_the_mesh_has_about_400_triangles(void **state)
{
    (void)state;
    uint32_t count = 0;
    build_hand();
    for (uint32_t i = 0; i < shape.index_count; i += 3) {
        const struct shape_vertex *const a = &shape.vertices[shape.indices[i]];
        const vec3 ab = v3_sub(shape.vertices[shape.indices[i + 1u]].position, a->position);
        const vec3 ac = v3_sub(shape.vertices[shape.indices[i + 2u]].position, a->position);
        count += v3_length(v3_cross(ab, ac)) > 1e-6f;
    }
    assert_in_range(count, 370, 430);
}

static void test_the_mesh_leaves_the_ring_and_the_number_on_the_handle_free(void **state)
{
    (void)state;
    build_hand();
    for (uint32_t i = 0; i < shape.vertex_count; i++) {
        const struct shape_vertex *const vertex = &shape.vertices[i];
        assert_true(vertex->position.z > NUMBER_AT);
        assert_float_equal(v3_length(vertex->normal), 1.0f, 1e-3f);
        assert_true(vertex->u >= 0.0f && vertex->u <= 1.0f);
    }
}

static void test_the_index_finger_lies_on_the_handle_and_fingers_wrap_it(void **state)
{
    (void)state;
    /* Heights of the skin above and below the handle, within the width of the handle. */
    float above = 0.0f, below = 0.0f;
    build_hand();
    for (uint32_t i = 0; i < shape.vertex_count; i++) {
        const vec3 p = shape.vertices[i].position;
        if (shape.vertices[i].v < 0.0f && f_abs(p.x) < 0.14f && p.z < 3.4f) {
            above = f_max(above, p.y);
            below = f_min(below, p.y);
        }
    }
    assert_true(above > 0.3f && above < 0.7f);
    assert_true(below < -0.5f && below > -0.9f);
}

/* The edge of a drawn hand is where the normals turn away from the camera. A normal that does not
 * agree with its triangles would leave a hole with a ragged edge. */
static void test_the_normals_of_the_skin_agree_with_its_triangles(void **state)
{
    (void)state;
    build_hand();
    for (uint32_t i = 0; i < shape.index_count; i += 3) {
        const struct shape_vertex *corners[3];
        for (uint32_t k = 0; k < 3u; k++) {
            corners[k] = &shape.vertices[shape.indices[i + k]];
        }
        const vec3 face = v3_cross(v3_sub(corners[1]->position, corners[0]->position),
                                   v3_sub(corners[2]->position, corners[0]->position));
        const vec3 sum = v3_add(v3_add(corners[0]->normal, corners[1]->normal), corners[2]->normal);
        if (corners[0]->v < 0.0f && v3_length(face) > 1e-6f) {
            assert_true(v3_dot(face, sum) > 0.0f);
        }
    }
}

/* The shader cuts a drawn finger at the circle around its bone. */
static void test_the_thumb_and_the_index_finger_have_directions_of_bones(void **state)
{
    (void)state;
    uint32_t count = 0;
    build_hand();
    for (uint32_t i = 0; i < shape.vertex_count; i++) {
        if (v3_length(bones[i]) > 0.0f) {
            const float ahead = v3_dot(bones[i], shape.vertices[i].normal);
            assert_true(shape.vertices[i].v < 0.0f);
            assert_float_equal(v3_length(bones[i]), 1.0f, 1e-4f);
            /* On the side of the finger, and on its round tip. */
            assert_true(f_abs(ahead) < 1e-4f || ahead > 0.4f);
            count++;
        }
    }
    assert_in_range(count, 60, 120);
}

static void test_the_sleeve_hangs_below_the_forearm(void **state)
{
    (void)state;
    float above = 0.0f, below = 0.0f;
    build_hand();
    for (uint32_t i = 0; i < shape.vertex_count; i++) {
        const struct shape_vertex *const vertex = &shape.vertices[i];
        if (vertex->v >= 0.0f) {
            above = f_max(above, vertex->position.y - HAND_WRIST_Y);
            below = f_max(below, HAND_WRIST_Y - vertex->position.y);
            /* The sleeve leaves the palm free. */
            assert_true(vertex->position.z > 4.6f);
        }
    }
    assert_true(below > 2.0f * above);
}

static void test_the_skin_is_dark_between_the_fingers_and_light_on_their_backs(void **state)
{
    (void)state;
    static uint8_t skin[HAND_SKIN_SIDE * HAND_SKIN_SIDE][3];
    uint32_t dark = 0, light = 0;
    hand_skin(skin);
    for (uint32_t i = 0; i < HAND_SKIN_SIDE * HAND_SKIN_SIDE; i++) {
        assert_true(skin[i][0] >= skin[i][1] && skin[i][1] >= skin[i][2]);
        dark += skin[i][0] < 100u;
        light += skin[i][0] > 200u;
    }
    assert_in_range(100u * dark / (HAND_SKIN_SIDE * HAND_SKIN_SIDE), 3, 30);
    assert_in_range(100u * light / (HAND_SKIN_SIDE * HAND_SKIN_SIDE), 15, 90);
}

/* Returns the point of the world to which a frame moves a point of the mesh. */
static vec3 moved(const float frame[16], vec3 p)
{
    return v3(frame[0] * p.x + frame[4] * p.y + frame[8] * p.z + frame[12],
              frame[1] * p.x + frame[5] * p.y + frame[9] * p.z + frame[13],
              frame[2] * p.x + frame[6] * p.y + frame[10] * p.z + frame[14]);
}

/* Returns the end of the sleeve along the forearm. */
static float sleeve_end(const struct hand_frames *frames)
{
    return HAND_CUFF_Z + (HAND_SLEEVE_END_Z - HAND_CUFF_Z) * frames->stretch;
}

/* Puts one poi into the scene. */
static struct scene_poi *hold(vec3 at_m, struct angles angles, float handle_rad)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        scene.poi[i].present = scene.bowl[i].present = 0;
    }
    struct scene_poi *const poi = &scene.poi[0];
    poi->present = 1;
    poi->ring_radius_m = 0.04f;
    poi->position_m = at_m;
    poi->angles = angles;
    poi->handle_rad = handle_rad;
    poi->sag_m = 0.0f;
    poi->water_m = 0.0f;
    poi->left_hand = 0;
    memset(poi->integrity, 255, sizeof poi->integrity);
    return poi;
}

static void test_the_arm_of_a_person_comes_from_the_near_side(void **state)
{
    (void)state;
    const vec3 wrist = v3(0.22f, 0.14f, 5.0f), elbow = v3(0.22f, 0.14f, 8.0f);
    core_scene(&core, &scene);
    for (int i = 0; i < 27; i++) {
        const struct angles angles = { (float)(i % 3 - 1) * 1.2f, (float)(i / 9 - 1) * 0.7f,
                                       (float)(i / 3 % 3 - 1) * 1.4f };
        struct hand_frames frames;
        hand_frames_of(&frames, &scene, hold(v3(0.1f, 0.0f, -0.1f), angles, 0.0f));
        /* The hand and the forearm meet at the wrist. */
        const vec3 joint = moved(frames.matrices[0], wrist);
        for (uint32_t k = 1; k < HAND_FRAMES; k++) {
            assert_true(v3_length(v3_sub(joint, moved(frames.matrices[k], wrist))) < 1e-4f);
        }
        const vec3 way = v3_sub(moved(frames.matrices[1], elbow), joint);
        assert_true(way.z > 0.02f && way.y >= 0.0f);
        /* The forearm is less steep than the view of the camera, so that the forearm runs down the
         * picture and away from the paper. */
        assert_true(way.y < 0.73f * v3_length(way));
    }
}

static void test_a_left_hand_is_the_mirror_image_of_a_right_hand(void **state)
{
    (void)state;
    const vec3 points[] = { { 0.62f, 0.24f, 3.46f }, { 0.22f, 0.14f, 8.0f }, { 1.1f, 0.5f, 9.0f } };
    core_scene(&core, &scene);
    struct scene_poi *const poi = hold(v3(0.0f, 0.02f, 0.0f), (struct angles){ 0 }, 0.0f);
    struct hand_frames right, left;
    hand_frames_of(&right, &scene, poi);
    poi->left_hand = 1;
    hand_frames_of(&left, &scene, poi);
    poi->left_hand = 0;
    for (uint32_t k = 0; k < HAND_FRAMES; k++) {
        const vec3 a = moved(right.matrices[k], points[k]), b = moved(left.matrices[k], points[k]);
        assert_true(a.x > 0.02f);
        assert_true(v3_length(v3_sub(v3(0.0f - a.x, a.y, a.z), b)) < 1e-5f);
    }
}

static void test_the_arm_of_a_bot_follows_the_handle(void **state)
{
    (void)state;
    for (int i = -3; i <= 3; i++) {
        struct hand_frames frames;
        const struct scene_poi *const poi =
            hold(v3(0.1f, 0.05f, 0.0f), (struct angles){ 0 }, 0.1f + (float)i);
        const vec3 back = scene_handle_axes(poi).back;
        hand_frames_of(&frames, &scene, poi);
        const float *const arm = frames.matrices[1];
        assert_true(v3_dot(v3_normalize_or(v3(arm[8], 0.0f, arm[10]), back), back) > 0.999f);
    }
}

static void test_the_arm_of_a_single_player_at_the_short_side_leaves_the_bowl_free(void **state)
{
    (void)state;
    const vec3 wrist = v3(0.22f, 0.14f, 5.0f), elbow = v3(0.22f, 0.14f, 8.0f);
    core_scene(&core, &scene);
    scene_use_turned(&scene);
    const vec3 near = view_to_world(true, v3(0.0f, 0.0f, 1.0f));
    const struct angles toward = { .yaw_rad = f_atan2(near.x, near.z) };
    for (uint32_t i = 0; i < 4; i++) {
        const float side = i & 1u ? -1.0f : 1.0f; /* Side of the bowl, to the player's right. */
        const float handle_rad = i < 2 ? 0.0f : 0.1f;
        struct scene_poi *const poi = hold(v3(0.0f, 0.0f, 0.0f), toward, handle_rad);
        struct hand_frames alone, among;
        poi->left_hand = side < 0.0f;
        hand_frames_of(&alone, &scene, poi);
        scene.poi[1].present = 1;
        hand_frames_of(&among, &scene, poi);
        const vec3 way = view_from_world(
            true, v3_sub(moved(alone.matrices[1], elbow), moved(alone.matrices[1], wrist)));
        const vec3 usual = view_from_world(
            true, v3_sub(moved(among.matrices[1], elbow), moved(among.matrices[1], wrist)));
        assert_true(way.z > 0.02f);
        assert_true(side * way.x / v3_length(way) < side * usual.x / v3_length(usual) - 0.2f);
    }
}

static void test_the_arm_ends_outside_the_tank(void **state)
{
    (void)state;
    for (int i = 0; i < 9; i++) {
        struct hand_frames frames;
        const vec3 at_m = v3(0.3f * (float)(i % 3 - 1), 0.05f, 0.2f * (float)(i / 3 - 1));
        hand_frames_of(&frames, &scene, hold(at_m, (struct angles){ 0 }, 0.3f * (float)i - 1.1f));
        const vec3 end = moved(frames.matrices[2], v3(0.22f, 0.14f, sleeve_end(&frames)));
        assert_true(f_abs(end.x) > 0.5f * scene.tank_size_m.x ||
                    f_abs(end.z) > 0.5f * scene.tank_size_m.z);
    }
}

/* Returns the depth of a hand of the scene in normalized device coordinates at point `p` of the
 * mesh, and writes the depth at which the ray of the same pixel crosses the top of the rim. */
static float depth_of(const float frame[16], float nearer, vec3 p, float *rim)
{
    const vec3 at_m = moved(frame, p);
    const float eye_m = scene.view.eye_m.y;
    const float rim_m = scene.wall_height_m - scene.tank_size_m.y;
    float seen[16];
    const struct display_transform whole = { .width = (float)WIDTH, .height = (float)HEIGHT };
    frame_view_projection(seen, &scene.view, &whole);
    const vec3 on_rim = v3_lerp(scene.view.eye_m, at_m, (eye_m - rim_m) / (eye_m - at_m.y));
    const vec3 points[2] = { at_m, on_rim };
    float depths[2];
    for (uint32_t i = 0; i < 2u; i++) {
        const vec3 q = points[i];
        const float z = seen[2] * q.x + seen[6] * q.y + seen[10] * q.z + seen[14];
        depths[i] = z / (seen[3] * q.x + seen[7] * q.y + seen[11] * q.z + seen[15]);
    }
    *rim = depths[1];
    return depths[0] - nearer;
}

static void test_a_low_hand_is_drawn_nearer_than_the_rim(void **state)
{
    (void)state;
    core_scene(&core, &scene);
    hold(v3(0.05f, -0.02f, 0.05f), (struct angles){ 0 }, 0.0f);
    picture(pixels[0]);
    const struct hand_frames *const frames = &display.renderer.hand.frames[0];
    for (uint32_t i = 0; i < 4u; i++) {
        const vec3 p = v3(0.3f, -0.5f, 2.7f + 0.6f * (float)i);
        float rim;
        assert_true(depth_of(frames->matrices[0], frames->nearer, p, &rim) < rim);
    }
    hold(v3(0.05f, 0.25f, 0.05f), (struct angles){ 0 }, 0.0f);
    picture(pixels[0]);
    assert_true(frames->nearer == 0.0f);
}

/* Counts the pixels of the poi's paper that differ between two pictures. */
static uint32_t changed_paper(const struct scene_poi *poi)
{
    const struct basis axes = vec_basis_from_angles(poi->angles);
    const struct basis camera = view_basis(&scene.view);
    const float tan_y = view_half_height_tan(&scene.view, (float)WIDTH / (float)HEIGHT);
    uint32_t count = 0;
    for (int i = 0; i < 400; i++) {
        const float x = ((float)(i % 20) - 9.5f) / 10.0f, z = ((float)(i / 20) - 9.5f) / 10.0f;
        const vec3 local = v3_scale(v3(x, 0.0f, z), 0.95f * poi->ring_radius_m);
        const vec3 p = v3_add(poi->position_m, vec_basis_to_world(&axes, local));
        const vec3 ray = v3_sub(p, scene.view.eye_m);
        const float deep = v3_dot(ray, camera.back) * -tan_y;
        const float u = v3_dot(ray, camera.right) / deep / ((float)WIDTH / (float)HEIGHT);
        const float v = v3_dot(ray, camera.up) / deep;
        if (x * x + z * z <= 1.0f && f_abs(u) < 1.0f && f_abs(v) < 1.0f) {
            const uint32_t column = (uint32_t)((0.5f + 0.5f * u) * (float)WIDTH);
            const uint32_t row = (uint32_t)((0.5f - 0.5f * v) * (float)HEIGHT);
            const uint32_t at = (row * WIDTH + column) * 3u;
            count += memcmp(pixels[0] + at, pixels[1] + at, 3) != 0;
        }
    }
    return count;
}

/* Draws the scene with its hands to pixels[0] and without hands to pixels[1]. Returns the number of
 * bytes that differ. */
static uint32_t compare_without_hands(void)
{
    const GLsizei whole = display.renderer.hand.mesh.index_count;
    uint32_t changed = 0;
    picture(pixels[0]);
    display.renderer.hand.mesh.index_count = 3; /* One triangle inside the sleeve. */
    picture(pixels[1]);
    display.renderer.hand.mesh.index_count = whole;
    for (uint32_t i = 0; i < PIXELS_SIZE; i++) {
        changed += pixels[0][i] != pixels[1][i];
    }
    return changed;
}

static void test_a_hand_is_drawn_but_hides_no_paper(void **state)
{
    (void)state;
    /* The second poi is under the arm of the first poi. */
    struct scene_poi *const far = hold(v3(0.0f, 0.06f, -0.12f), (struct angles){ 0 }, 0.0f);
    scene.fish_count = 0;
    scene.poi[1] = *far;
    scene.poi[1].owner = 1;
    scene.poi[1].position_m = v3(0.11f, 0.03f, 0.16f);
    assert_true(compare_without_hands() > PIXELS_SIZE / 50u);
    assert_int_equal(changed_paper(&scene.poi[0]), 0);
    assert_int_equal(changed_paper(&scene.poi[1]), 0);
    assert_true(display.renderer.hand.frames[0].covers_paper);
    assert_false(display.renderer.hand.frames[1].covers_paper);
    scene.poi[1].left_hand = 1;
    assert_true(compare_without_hands() > PIXELS_SIZE / 50u);
    assert_int_equal(changed_paper(&scene.poi[0]), 0);
    assert_int_equal(changed_paper(&scene.poi[1]), 0);
}

static void test_the_free_hand_of_the_player_holds_the_fan(void **state)
{
    (void)state;
    core_scene(&core, &scene);
    struct scene_poi *const poi = hold(v3(0.3f, 0.1f, 0.2f), (struct angles){ 0 }, 0.0f);
    struct scene_fan *const fan = &scene.fan[0];
    *fan = (struct scene_fan){ .present = 1, .x_m = -0.05f, .z_m = -0.1f, .radius_m = 0.1f };
    for (uint8_t left = 0; left < 2u; left++) {
        poi->left_hand = left;
        assert_true(compare_without_hands() > PIXELS_SIZE / 50u);
        const struct hand_frames *const frames = &display.renderer.hand.fan_frames[0];
        const vec3 back = vec_basis_from_angles(quad_fan_angles(&scene, fan)).back;
        const vec3 centre = v3(fan->x_m, QUAD_FAN_HEIGHT_M, fan->z_m);
        const vec3 end = v3_muladd(centre, back, QUAD_FAN_HANDLE * fan->radius_m);
        /* The end of the handle is between the fingers and the palm. */
        assert_true(v3_length(v3_sub(end, moved(frames->matrices[0], v3(0, 0, 3.6f)))) < 1e-4f);
        assert_int_equal(frames->left, !left);
        const vec3 sleeve = moved(frames->matrices[2], v3(0.22f, 0.14f, sleeve_end(frames)));
        assert_true(sleeve.z > 0.5f * scene.tank_size_m.z);
        assert_int_equal(changed_paper(poi), 0);
    }
    fan->present = poi->left_hand = 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_mesh_has_about_400_triangles),
        cmocka_unit_test(test_the_mesh_leaves_the_ring_and_the_number_on_the_handle_free),
        cmocka_unit_test(test_the_index_finger_lies_on_the_handle_and_fingers_wrap_it),
        cmocka_unit_test(test_the_normals_of_the_skin_agree_with_its_triangles),
        cmocka_unit_test(test_the_thumb_and_the_index_finger_have_directions_of_bones),
        cmocka_unit_test(test_the_sleeve_hangs_below_the_forearm),
        cmocka_unit_test(test_the_skin_is_dark_between_the_fingers_and_light_on_their_backs),
        WITH_DISPLAY(test_the_arm_of_a_person_comes_from_the_near_side),
        WITH_DISPLAY(test_a_left_hand_is_the_mirror_image_of_a_right_hand),
        WITH_DISPLAY(test_the_arm_of_a_bot_follows_the_handle),
        WITH_DISPLAY(test_the_arm_of_a_single_player_at_the_short_side_leaves_the_bowl_free),
        WITH_DISPLAY(test_the_arm_ends_outside_the_tank),
        WITH_DISPLAY(test_a_low_hand_is_drawn_nearer_than_the_rim),
        WITH_DISPLAY(test_a_hand_is_drawn_but_hides_no_paper),
        WITH_DISPLAY(test_the_free_hand_of_the_player_holds_the_fan),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
