package org.dronewatch.sensor.acoustic.array;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.random.RandomGenerator;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;

/**
 * The accuracy with which an array finds the direction of one sound in noise that is incoherent between microphones:
 * the stochastic Cramer-Rao bound (P. Stoica and A. Nehorai, IEEE Trans. ASSP 38, 1783, 1990), which good methods reach
 * once the sound is detected. In a narrow band, the inverse of the variance of an angle is
 * {@code 2 T S k^2 D / (1 + 1 / (N S))}, where T is the number of snapshots, S the signal-to-noise ratio of one
 * microphone, k the wavenumber, N the number of microphones, and D the sum of the squares of the microphones' positions
 * relative to their centre, each projected onto the derivative of the sound's unit direction vector with respect to the
 * angle. The contributions of all bands are added, each with a number of snapshots equal to its width times the
 * duration of a look. Bands in which neighbouring microphones are more than half a wavelength apart are left out, since
 * their directions are ambiguous. The standard deviation due to the array itself ({@link ArraySettings#accuracy}) is
 * added in quadrature. Immutable.
 */
public final class DirectionFinder {
    /** Width of an octave band divided by its midband frequency (IEC 61260-1, base ten). */
    private static final double OCTAVE = Math.pow(10.0, 0.15) - Math.pow(10.0, -0.15);

    /** A direction whose error is larger than this does not count as a measurement. */
    private static final double GREATEST = Math.toRadians(30.0);

    private final ArraySettings array;
    private final double soundSpeed;
    private final double duration;

    /**
     * A direction finder for an array.
     *
     * @param soundSpeed speed of sound, above 0, m/s
     * @param duration duration of a look, s, above 0
     */
    public DirectionFinder(ArraySettings array, double soundSpeed, double duration) {
        this.array = array;
        this.soundSpeed = soundSpeed;
        this.duration = duration;
    }

    /**
     * Inverse variance of the direction divided by the sum of squared distances, 1/m2, from all bands together.
     *
     * @param ratios signal-to-noise ratio of one microphone in each octave band, dB; minus infinity where nothing is
     *     heard
     */
    double information(double[] ratios) {
        double sum = 0.0;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            double frequency = OctaveBands.midband(band);
            if (array.spacing() <= 0.5 * soundSpeed / frequency) {
                sum += information(frequency, OCTAVE * frequency * duration, Levels.toRatio(ratios[band]));
            }
        }
        return sum;
    }

    /**
     * The same quantity for one narrow band.
     *
     * @param snapshots number of independent snapshots
     * @param ratio signal-to-noise ratio of one microphone, 0 or more
     */
    double information(double frequency, double snapshots, double ratio) {
        if (!(ratio > 0.0)) {
            return 0.0;
        }
        double waveNumber = 2.0 * Math.PI * frequency / soundSpeed;
        return 2.0 * snapshots * ratio * waveNumber * waveNumber / (1.0 + 1.0 / (array.microphones() * ratio));
    }

    /** The sum of the squared distances of the microphones from their centre along a vector, m2 times its square. */
    double spread(Position vector) {
        double sum = 0.0;
        double squares = 0.0;
        for (int i = 0; i < array.microphones(); i++) {
            double along = array.place(i).dot(vector);
            sum += along;
            squares += along * along;
        }
        return Math.max(0.0, squares - sum * sum / array.microphones());
    }

    /** Standard error of the bearing, rad; infinite where it cannot be measured. */
    double bearingError(Direction direction, double[] ratios) {
        Position turned = new Position(
                Math.cos(direction.elevation()) * Math.cos(direction.azimuth()),
                -Math.cos(direction.elevation()) * Math.sin(direction.azimuth()),
                0.0);
        return error(turned, ratios, array.accuracy() / Math.cos(direction.elevation()));
    }

    /** Standard error of the elevation, rad; infinite where it cannot be measured. */
    double elevationError(Direction direction, double[] ratios) {
        Position raised = new Position(
                -Math.sin(direction.elevation()) * Math.sin(direction.azimuth()),
                -Math.sin(direction.elevation()) * Math.cos(direction.azimuth()),
                Math.cos(direction.elevation()));
        return error(raised, ratios, array.accuracy());
    }

    private double error(Position change, double[] ratios, double calibration) {
        double inverse = information(ratios) * spread(change);
        return inverse > 0.0 ? Math.hypot(1.0 / Math.sqrt(inverse), calibration) : Double.POSITIVE_INFINITY;
    }

    /**
     * A measured direction of the source, with a random error.
     *
     * @param array position of the array, m
     * @param source position of the source, m
     * @param ratios signal-to-noise ratio of one microphone in each octave band, dB
     * @return empty if the array finds no direction; an elevation that the array cannot measure is set to 0
     */
    public Optional<Found> find(Position array, Position source, double[] ratios, RandomGenerator random) {
        Position vector = source.minus(array);
        if (!this.array.findsDirections() || !(vector.length() > 0.0)) {
            return Optional.empty();
        }
        Direction direction = Direction.of(vector);
        double bearingError = bearingError(direction, ratios);
        // Overhead, a bearing means little, but the direction is as accurate as anywhere else.
        if (!(bearingError * Math.cos(direction.elevation()) <= GREATEST)) {
            return Optional.empty();
        }
        double elevationError = elevationError(direction, ratios);
        double turn = bearingError * random.nextGaussian();
        double raise = random.nextGaussian();
        boolean hasElevation = elevationError <= GREATEST;
        // A level ring cannot distinguish sound from below from sound from above; it assumes that everything is above.
        double truth = this.array.shape() == ArraySettings.Shape.RING
                ? Math.abs(direction.elevation())
                : direction.elevation();
        double elevation = hasElevation ? truth + elevationError * raise : 0.0;
        double limited = Math.max(-0.5 * Math.PI, Math.min(0.5 * Math.PI, elevation));
        Direction believed = new Direction(direction.azimuth() + turn, limited);
        double across = bearingError * Math.cos(limited);
        double error = hasElevation ? Math.max(across, elevationError) : across;
        return Optional.of(new Found(
                new Sighting(array, believed, OptionalDouble.empty(), hasElevation, error, OptionalDouble.empty()),
                bearingError,
                hasElevation ? OptionalDouble.of(elevationError) : OptionalDouble.empty()));
    }

    /**
     * A measured direction.
     *
     * @param sighting the estimated direction of the source
     * @param bearingError standard error of its bearing, rad
     * @param elevationError standard error of its elevation, rad; empty if it is not measured
     */
    public record Found(Sighting sighting, double bearingError, OptionalDouble elevationError) {}
}
