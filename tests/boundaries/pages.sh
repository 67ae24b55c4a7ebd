#!/bin/bash
# pages.sh [PAGE ...] -- checks the form and the links of the Markdown pages; without arguments, of all pages.
#
# Outside tables and code blocks no line has more than 160 characters, and no sentence more than 30 words.
# Every relative link names an existing file, and every anchor names a heading of the page that it points into.
# In a text of the form "`function()` in [file](path)", the file contains the function's name.
# An inline code span counts as one word. Prints one line for each breach. Exits 1 on any.
set -u
[ $# -gt 0 ] || mapfile -t pages < <(git ls-files -co --exclude-standard '*.md')
[ $# -eq 0 ] || pages=("$@")

exec perl -CSDA - "${pages[@]}" <<'PERL'
use strict;
use warnings;

my %headings;
my $failed = 0;

sub read_lines {
    my ($path) = @_;
    open(my $file, '<', $path) or return ();
    chomp(my @lines = <$file>);
    return @lines;
}

# Removes the lines of code blocks: fenced ones, and those indented by four spaces after an empty line.
sub without_code {
    my ($fenced, $indented, $was_empty, @kept) = (0, 0, 1);
    for my $line (@_) {
        if ($line =~ /^\s*```/) {
            $fenced = !$fenced;
            push @kept, '';
            next;
        }
        $indented = 0 if $line =~ /^ {0,3}\S/;
        $indented = 1 if $was_empty && $line =~ /^ {4,}\S/;
        $was_empty = $line =~ /^\s*$/;
        push @kept, $fenced || $indented ? '' : $line;
    }
    return @kept;
}

# Returns the anchors of a page's headings, as GitHub forms them.
sub headings {
    my ($path) = @_;
    return $headings{$path} if $headings{$path};
    my %slugs;
    for my $line (without_code(read_lines($path))) {
        next unless $line =~ /^#+\s+(.*?)\s*$/;
        my $slug = lc $1;
        $slug =~ s/[^\w\- ]//g;
        $slug =~ tr/ /-/;
        $slugs{$slug} = 1;
    }
    return $headings{$path} = \%slugs;
}

sub check_links {
    my ($page, $number, $line) = @_;
    $line =~ s/`[^`]*`//g;
    (my $folder = $page) =~ s{[^/]*$}{};
    while ($line =~ /\]\(([^)\s]+)\)/g) {
        my $link = $1;
        next if $link =~ /^[a-z]+:/;
        my ($path, $anchor) = split /#/, $link, 2;
        my $target = $path eq '' ? $page : $folder . $path;
        my $resolves = -e $target && (!defined $anchor || headings($target)->{$anchor});
        next if $resolves;
        print "$page:$number: the link $link does not resolve\n";
        $failed = 1;
    }
}

sub check_functions {
    my ($page, $number, $line) = @_;
    (my $folder = $page) =~ s{[^/]*$}{};
    while ($line =~ /((?:`\w+\(\)`,? )+)in \[[^\]]*\]\(([^)#]+)\)/g) {
        my ($functions, $path) = ($1, $2);
        my $source = join("\n", read_lines($folder . $path));
        while ($functions =~ /(\w+)\(\)/g) {
            next if $source =~ /\b$1\(/;
            print "$page:$number: $path has no $1()\n";
            $failed = 1;
        }
    }
}

# Returns the sentences of over 30 words in a paragraph, each by its first words.
sub long_sentences {
    my ($text) = @_;
    my @long;
    $text =~ s/`[^`]*`/code/g;
    $text =~ s/!?\[([^\]]*)\]\([^)]*\)/$1/g;
    for my $sentence (split /(?<=[.!?])[)"*_\]]*\s+/, $text) {
        my @words = grep { /\w/ } split ' ', $sentence;
        push @long, scalar(@words) . ' words: ' . join(' ', @words[0 .. 5]) . ' ..' if @words > 30;
    }
    return @long;
}

for my $page (@ARGV) {
    my ($number, $first, $paragraph, @breaches) = (0, 0, '');
    my $end_paragraph = sub {
        push @breaches, "$page:$first: a sentence of $_" for long_sentences($paragraph);
        $paragraph = '';
    };
    my @lines = (without_code(read_lines($page)), "");
    for my $line (@lines) {
        $number++;
        check_links($page, $number, $line);
        check_functions($page, $number, $line);
        my $is_table = $line =~ /^\s*\|/;
        push @breaches, "$page:$number: over 160 columns" if !$is_table && length($line) > 160;
        $end_paragraph->() if $is_table || $line =~ /^\s*$|^#|^\s*([-*]|\d+\.)\s/;
        next if $is_table;
        $first = $number if $paragraph eq '';
        my $is_heading = $line =~ /^#/;
        $line =~ s/^\s*([-*]|\d+\.|#+|>)\s+//;
        $paragraph .= "$line ";
        $end_paragraph->() if $is_heading;
    }
    print "$_\n" for @breaches;
    $failed = 1 if @breaches;
}
exit $failed;
PERL
