package org.dronewatch.sensor.acoustic.array;

import java.util.Locale;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.sound.Levels;

/**
 * An array of microphones around the sensor's position.
 *
 * @param microphones number of microphones, 2 to 4096; at least 3 for a ring and 4 for a sphere
 * @param aperture length of a line, or diameter of a ring or a sphere, above 0 and at most 100 m
 * @param shape arrangement of the microphones
 * @param accuracy standard deviation that a measured direction has at any signal-to-noise ratio, due to errors in the
 *     positions, phases and gains of the microphones and to the air, 0 to pi/6 rad; the default of one degree is an
 *     assumption
 * @param axis direction of a horizontal line, clockwise from north, -4 pi to 4 pi rad; it has no effect for other
 *     shapes
 */
public record ArraySettings(
        @In(value = Quantity.NUMBER, from = 2, to = 4096) int microphones,
        @In(value = Quantity.LENGTH, above = 0, to = 100) double aperture,
        Shape shape,
        @In(value = Quantity.ANGLE, from = 0, to = Math.PI / 6) double accuracy,
        @In(value = Quantity.ANGLE, from = -In.TWO_TURNS, to = In.TWO_TURNS) double axis) {
    private static final double GOLDEN_ANGLE = Math.PI * (3.0 - Math.sqrt(5.0));

    /** An arrangement of microphones. */
    public enum Shape {
        /**
         * A horizontal line, evenly spaced: it measures only the angle to the line, and so cannot cue other sensors.
         */
        LINE(2),
        /**
         * A horizontal circle, evenly spaced: it measures bearing and elevation, the latter inaccurately near the
         * horizon.
         */
        RING(3),
        /** A sphere, nearly evenly spaced: it measures bearing and elevation equally well. */
        SPHERE(4);

        private final int fewest;

        Shape(int fewest) {
            this.fewest = fewest;
        }
    }

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public ArraySettings {
        Limits.check(ArraySettings.class, microphones, aperture, shape, accuracy, axis);
        if (microphones < shape.fewest) {
            throw new IllegalArgumentException("microphones " + microphones + " must be at least " + shape.fewest
                    + " for a " + shape.name().toLowerCase(Locale.ROOT));
        }
    }

    /** A sphere of the given diameter, m, with the given number of microphones. */
    @Defaults({"microphones", "aperture"})
    public static ArraySettings of(int microphones, double aperture) {
        return new ArraySettings(microphones, aperture, Shape.SPHERE, Math.toRadians(1.0), 0.0);
    }

    /** This array in another arrangement. */
    public ArraySettings withShape(Shape other) {
        return SettingsForm.with(this, "shape", other);
    }

    /** This array with another standard deviation of the measured direction, rad. */
    public ArraySettings withAccuracy(double radians) {
        return SettingsForm.with(this, "accuracy", radians);
    }

    /** This array with another direction of its line, clockwise from north, rad. */
    public ArraySettings withAxis(double bearing) {
        return SettingsForm.with(this, "axis", bearing);
    }

    /**
     * Gain in signal-to-noise ratio over one microphone against incoherent noise, {@code 10 lg N} for N microphones,
     * dB.
     */
    public double gain() {
        return Levels.ofRatio(microphones);
    }

    /** The distance between neighbouring microphones, m: on a sphere, that of a square lattice of the same density. */
    public double spacing() {
        return switch (shape) {
            case LINE -> aperture / (microphones - 1);
            case RING -> aperture * Math.sin(Math.PI / microphones);
            case SPHERE -> aperture * Math.sqrt(Math.PI / microphones);
        };
    }

    /**
     * The half-power width of the main lobe at a wavelength lambda, rad: for a line of N microphones at a spacing d,
     * the broadside width {@code 0.886 lambda / (N d)}; for other shapes, about that of a line as long as their
     * diameter.
     *
     * @param wavelength wavelength lambda, above 0, m
     */
    public double beamwidth(double wavelength) {
        return 0.886 * wavelength / (shape == Shape.LINE ? microphones * spacing() : aperture);
    }

    /** Whether the array measures a direction, rather than an angle to a line. */
    public boolean findsDirections() {
        return shape != Shape.LINE;
    }

    /** The position of a microphone relative to the centre, m. */
    Position place(int microphone) {
        double radius = 0.5 * aperture;
        switch (shape) {
            case LINE -> {
                double along = -radius + microphone * spacing();
                return new Position(along * Math.sin(axis), along * Math.cos(axis), 0.0);
            }
            case RING -> {
                double angle = 2.0 * Math.PI * microphone / microphones;
                return new Position(radius * Math.sin(angle), radius * Math.cos(angle), 0.0);
            }
            default -> {
                // A spiral from pole to pole (M. A. Gonzalez, Mathematical Geosciences 42, 49, 2010).
                double height = 1.0 - (2.0 * microphone + 1.0) / microphones;
                double level = radius * Math.sqrt(1.0 - height * height);
                double angle = microphone * GOLDEN_ANGLE;
                return new Position(level * Math.sin(angle), level * Math.cos(angle), radius * height);
            }
        }
    }
}
