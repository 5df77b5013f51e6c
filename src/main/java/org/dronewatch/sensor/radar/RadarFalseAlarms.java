package org.dronewatch.sensor.radar;

import java.util.Optional;
import org.dronewatch.sensor.alarm.FalseAlarmRate;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * False alarms of a radar due to noise: their mean number per scan is the number of resolution cells times the
 * probability in one cell (Skolnik, Introduction to Radar Systems, section 2.5). Noise is independent between cells and
 * between scans.
 *
 * @param probability probability of a false alarm in one cell and one scan, 1e-15 to 0.01; omit it to use that of a
 *     detection of kind {@code chance} ({@code falseAlarm}), or the one that the data sheet states
 * @param cells number of resolution cells in a scan, 1 to 1e12; omit it to compute it for a hardware budget: range
 *     cells times beams times Doppler cells
 * @param gate number of cells within which detections of successive scans count as those of one target, 1 to 1e6
 */
public record RadarFalseAlarms(
        @In(value = Quantity.NUMBER, from = 1e-15, to = 0.01) Optional<Double> probability,
        @In(value = Quantity.NUMBER, from = 1, to = 1e12) Optional<Double> cells,
        @In(value = Quantity.NUMBER, from = 1, to = 1e6) double gate) {
    /**
     * Probability and number of cells from the radar's other settings, and an assumed gate of 27 cells: a cell and its
     * neighbours in range, azimuth and elevation.
     */
    @Defaults
    public static final RadarFalseAlarms DEFAULT = new RadarFalseAlarms(Optional.empty(), Optional.empty(), 27.0);

    /** Checks the limits. */
    public RadarFalseAlarms {
        Limits.check(RadarFalseAlarms.class, probability, cells, gate);
    }

    /** These false alarms with another probability in one cell and one scan. */
    public RadarFalseAlarms withProbability(double ofOneCell) {
        return SettingsForm.with(this, "probability", Optional.of(ofOneCell));
    }

    /** These false alarms with another number of cells in a scan. */
    public RadarFalseAlarms withCells(double number) {
        return SettingsForm.with(this, "cells", Optional.of(number));
    }

    /** These false alarms with another gate, in cells. */
    public RadarFalseAlarms withGate(double number) {
        return SettingsForm.with(this, "gate", number);
    }

    /**
     * The rate of a radar.
     *
     * @param scans scans per second, Hz
     * @throws IllegalArgumentException when the probability or the number of cells is not set and does not follow from
     *     the radar's other settings
     */
    FalseAlarmRate rate(ResolutionCells scan, LinkBudget budget, RadarDetection detection, double scans) {
        double all = cells(scan, budget);
        double each = probability(budget, detection);
        if (all * each > FalseAlarmRate.MOST_PER_LOOK) {
            throw new IllegalArgumentException("falseAlarms: " + Quantity.NUMBER.inWords(Math.rint(all))
                    + " cells, each with a probability of " + Quantity.NUMBER.inWords(each) + ", raise "
                    + Quantity.NUMBER.inBrief(all * each) + " false alarms per scan; there must be at most "
                    + (int) FalseAlarmRate.MOST_PER_LOOK);
        }
        return new FalseAlarmRate(all * each, (long) Math.max(1.0, Math.floor(all / gate)), 1, scans);
    }

    /** The probability of a false alarm in one cell and one scan. */
    private double probability(LinkBudget budget, RadarDetection detection) {
        if (detection instanceof RadarDetection.Chance chance) {
            if (probability.isPresent()) {
                throw new IllegalArgumentException(
                        "falseAlarms.probability and detection.falseAlarm are mutually exclusive:"
                                + " omit falseAlarms.probability");
            }
            return chance.falseAlarm();
        }
        if (probability.isEmpty() && budget instanceof LinkBudget.DataSheet sheet) {
            return sheet.falseAlarm();
        }
        return probability.orElseThrow(() -> new IllegalArgumentException(
                "falseAlarms.probability is missing: a fixed threshold does not determine it"));
    }

    /** The number of resolution cells in a scan, 1 or more. */
    double cells(ResolutionCells scan, LinkBudget budget) {
        if (cells.isPresent()) {
            return cells.get();
        }
        if (budget instanceof LinkBudget.Hardware hardware) {
            return scan.count(hardware);
        }
        throw new IllegalArgumentException(
                "falseAlarms.cells is missing: a budget from a data sheet does not give the number of"
                        + " resolution cells");
    }
}
