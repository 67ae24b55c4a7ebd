/* menu_tag.h -- finds the tag (item) of the operator's menu that opens a page. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_MENU_TAG_H
#define KINGYO_TESTS_UNIT_SUPPORT_MENU_TAG_H

#include "core/game/menu/menu_pages.h"

/* Returns the index of the tag (menu item) that opens `page`. The tag is on the parent page of
 * `page`. Returns MENU_TAG_MAX if there is no such tag. */
static inline uint32_t menu_tag_of(uint8_t page)
{
    const uint8_t parent = menu_page_desc_of(page)->parent;
    uint32_t tag = 0;
    while (parent < MENU_PAGE_COUNT && tag < MENU_TAG_MAX &&
           menu_page_at(parent, false, tag) != page) {
        tag++;
    }
    return parent < MENU_PAGE_COUNT ? tag : MENU_TAG_MAX;
}

#endif
