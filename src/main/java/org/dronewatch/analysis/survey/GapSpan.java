package org.dronewatch.analysis.survey;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.FieldCoverage;

/**
 * A gap that extends over several heights. Its parts are gaps at neighbouring heights, each above the one before.
 *
 * @param lowest the number, in the grid, of the lowest height of the gap
 * @param highest the number of the highest height of the gap
 * @param height the number of the height at which the gap is largest; in a tie, that of the lowest
 * @param number the number of the largest part in the {@link GapMap} of that height
 * @param gap the largest part
 */
public record GapSpan(int lowest, int highest, int height, int number, Gap gap) {
    /** How many of the largest gaps at each height are compared with those at the next height. */
    private static final int MOST_OF_A_HEIGHT = 8;

    /** Two gaps one above the other belong together if they share this fraction of the smaller one's cells. */
    private static final double SHARED = 0.5;

    /**
     * The gaps of a coverage over all heights, the largest first, by the area of the largest part; in a tie, the lowest
     * first. At each height, only the eight largest gaps are considered.
     */
    public static List<GapSpan> of(FieldCoverage coverage) {
        List<Part> parts = new ArrayList<>();
        GapMap below = null;
        List<Part> before = List.of();
        for (int height = 0; height < coverage.field().grid().heights().size(); height++) {
            GapMap map = GapMap.of(coverage, height);
            List<Part> here = IntStream.range(
                            0, Math.min(MOST_OF_A_HEIGHT, map.gaps().size()))
                    .mapToObj(
                            number -> new Part(map.height(), number, map.gaps().get(number)))
                    .toList();
            for (Part lower : before) {
                for (Part upper : here) {
                    if (overlap(below, lower, map, upper)) {
                        upper.join(lower);
                    }
                }
            }
            parts.addAll(here);
            below = map;
            before = here;
        }
        return parts.stream()
                .filter(part -> part.root() == part)
                .map(part -> part.span(parts))
                .sorted(Comparator.comparingInt((GapSpan span) -> -span.gap().cells())
                        .thenComparingInt(GapSpan::height)
                        .thenComparingInt(GapSpan::number))
                .toList();
    }

    private static boolean overlap(GapMap below, Part lower, GapMap above, Part upper) {
        FieldGrid grid = above.coverage().field().grid();
        boolean isUpperSmaller = upper.gap.cells() <= lower.gap.cells();
        int[] cells = isUpperSmaller ? above.cells(upper.number) : below.cells(lower.number);
        int shared = 0;
        for (int cell : cells) {
            boolean both = isUpperSmaller
                    ? below.contains(lower.number, grid.column(cell), grid.row(cell))
                    : above.contains(upper.number, grid.column(cell), grid.row(cell));
            shared += both ? 1 : 0;
        }
        return shared >= SHARED * cells.length;
    }

    /** A gap of one height; those that belong together have the same root. */
    private static final class Part {
        private final int height;
        private final int number;
        private final Gap gap;
        private Part parent = this;

        Part(int height, int number, Gap gap) {
            this.height = height;
            this.number = number;
            this.gap = gap;
        }

        Part root() {
            return parent == this ? this : parent.root();
        }

        void join(Part other) {
            root().parent = other.root();
        }

        GapSpan span(List<Part> all) {
            int lowest = height;
            int highest = height;
            Part largest = this;
            for (Part one : all) {
                if (one.root() == this) {
                    lowest = Math.min(lowest, one.height);
                    highest = Math.max(highest, one.height);
                    largest = one.isLargerThan(largest) ? one : largest;
                }
            }
            return new GapSpan(lowest, highest, largest.height, largest.number, largest.gap);
        }

        private boolean isLargerThan(Part other) {
            return gap.cells() > other.gap.cells() || gap.cells() == other.gap.cells() && height < other.height;
        }
    }
}
