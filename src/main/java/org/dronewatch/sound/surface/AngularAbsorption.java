package org.dronewatch.sound.surface;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.sound.OctaveBands;

/**
 * Absorption as a function of the angle of incidence, from a table: linear between the angles in the table, constant
 * below the first and above the last.
 */
public final class AngularAbsorption {
    private final List<AbsorptionAtAngle> table;
    private final double[] angles;
    private final double[][] absorption;

    /**
     * A table.
     *
     * @param table rows of the table, in order of increasing angle
     * @throws IllegalArgumentException when it is empty, or an angle is not greater than the one before it
     */
    public AngularAbsorption(List<AbsorptionAtAngle> table) {
        this.table = List.copyOf(table);
        if (this.table.isEmpty()) {
            throw new IllegalArgumentException("absorption by angle needs at least one angle");
        }
        this.angles = this.table.stream().mapToDouble(AbsorptionAtAngle::angle).toArray();
        for (int i = 1; i < angles.length; i++) {
            if (!(angles[i] > angles[i - 1])) {
                throw new IllegalArgumentException("angle " + (float) Math.toDegrees(angles[i])
                        + " deg must be above the one before it, " + (float) Math.toDegrees(angles[i - 1]) + " deg");
            }
        }
        this.absorption = new double[OctaveBands.COUNT][angles.length];
        for (int i = 0; i < angles.length; i++) {
            List<Double> row = this.table.get(i).absorption().toList();
            for (int band = 0; band < OctaveBands.COUNT; band++) {
                absorption[band][i] = row.get(band);
            }
        }
    }

    /** The table. */
    public List<AbsorptionAtAngle> table() {
        return table;
    }

    /**
     * The absorbed fraction in a band.
     *
     * @param cosine cosine of the angle of incidence, from the normal, 0 to 1
     */
    public double at(int band, double cosine) {
        double angle = Math.acos(Math.min(1.0, Math.max(0.0, cosine)));
        int above = 0;
        while (above < angles.length && angles[above] <= angle) {
            above++;
        }
        double[] values = absorption[band];
        if (above == 0) {
            return values[0];
        }
        if (above == angles.length) {
            return values[above - 1];
        }
        double along = (angle - angles[above - 1]) / (angles[above] - angles[above - 1]);
        return values[above - 1] + along * (values[above] - values[above - 1]);
    }

    /**
     * The absorbed fractions of sound in a diffuse field, by band: the integral of
     * {@code absorption(angle) sin(2 angle)} from 0 to pi/2 (Paris, Philosophical Magazine 5, 1928), exact for the
     * table.
     */
    public List<Double> atRandomIncidence() {
        List<Double> mean = new ArrayList<>();
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            double[] values = absorption[band];
            int last = angles.length - 1;
            double sum = values[0] * constant(0.0, angles[0]) + values[last] * constant(angles[last], Math.PI / 2.0);
            for (int i = 0; i < last; i++) {
                double slope = (values[i + 1] - values[i]) / (angles[i + 1] - angles[i]);
                sum += (values[i] - slope * angles[i]) * constant(angles[i], angles[i + 1])
                        + slope * (rising(angles[i + 1]) - rising(angles[i]));
            }
            mean.add(Math.min(1.0, Math.max(0.0, sum)));
        }
        return mean;
    }

    /** The integral of {@code sin 2x}. */
    private static double constant(double from, double to) {
        return 0.5 * (Math.cos(2.0 * from) - Math.cos(2.0 * to));
    }

    /** An antiderivative of {@code x sin 2x}. */
    private static double rising(double x) {
        return 0.25 * Math.sin(2.0 * x) - 0.5 * x * Math.cos(2.0 * x);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof AngularAbsorption same && same.table.equals(table);
    }

    @Override
    public int hashCode() {
        return table.hashCode();
    }

    @Override
    public String toString() {
        return table.toString();
    }
}
