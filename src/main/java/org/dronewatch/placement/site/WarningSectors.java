package org.dronewatch.placement.site;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.placement.plan.WarningMeasure;

/** The warnings of flights by the eighths of the compass from which they come. */
final class WarningSectors {
    private static final int SECTORS = 8;
    private static final double EIGHTH = 0.25 * Math.PI;

    private final WarningPlacement placement;
    private final boolean isWorst;

    /**
     * The flights of a placement.
     *
     * @param placement a placement with a row for each flight: by condition, then by height, then by bearing
     */
    WarningSectors(WarningPlacement placement) {
        this.placement = placement;
        this.isWorst = placement.measure() == WarningMeasure.WORST;
    }

    /**
     * The eighth in which a layout gains most over another. If the worst warning counts, that is the one in which the
     * other layout's is the shortest. Empty if nothing is gained there.
     */
    Optional<SectorGain> gain(List<Integer> before, List<Integer> after) {
        double[] had = bySector(before);
        double[] has = bySector(after);
        int best = 0;
        for (int sector = 1; sector < SECTORS; sector++) {
            double more = (has[sector] - had[sector]) - (has[best] - had[best]);
            boolean isShorter = isWorst && had[sector] < had[best];
            boolean isAsShort = !isWorst || had[sector] == had[best];
            best = isShorter || isAsShort && more > 0.0 ? sector : best;
        }
        List<Double> heights = placement.grid().heights();
        return has[best] > had[best]
                ? Optional.of(new SectorGain(
                        best * EIGHTH, heights.get(0), heights.get(heights.size() - 1), had[best], has[best]))
                : Optional.empty();
    }

    /** The mean or the worst warning of the flights from each eighth, under the condition that is worst there, s. */
    private double[] bySector(List<Integer> layout) {
        double[] warnings = placement.warnings(layout);
        double[] values = new double[SECTORS];
        Arrays.fill(values, Double.POSITIVE_INFINITY);
        for (int start = 0; start < warnings.length; start += placement.flights()) {
            for (int sector = 0; sector < SECTORS; sector++) {
                int its = sector;
                DoubleStream flights = IntStream.range(start, start + placement.flights())
                        .filter(row -> sector(row) == its)
                        .mapToDouble(row -> warnings[row]);
                values[sector] = Math.min(values[sector], (isWorst ? flights.min() : flights.average()).orElse(0.0));
            }
        }
        return values;
    }

    private static int sector(int row) {
        double turns = (double) (row % InboundWarnings.BEARINGS) / InboundWarnings.BEARINGS;
        return (int) Math.floorMod(Math.round(turns * SECTORS), (long) SECTORS);
    }
}
