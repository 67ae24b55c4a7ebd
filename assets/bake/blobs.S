/* blobs.S -- links the baked files as constants. The assembler finds the files in its include
 * path. */
    .macro blob name
    .global asset_\name
    .balign 16
asset_\name:
    .incbin "\name\().bin"
    .endm

    .section .rodata
    blob caustics
    blob patterns
    blob environment
    blob backdrop
    blob wood
    blob paper
    blob font

    .section .note.GNU-stack,"",%progbits
