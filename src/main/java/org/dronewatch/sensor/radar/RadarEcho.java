package org.dronewatch.sensor.radar;

import java.util.Optional;
import java.util.function.DoubleBinaryOperator;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.sensor.radio.RadioPath;
import org.dronewatch.sensor.radio.TwoRays;
import org.dronewatch.world.Obstacle;
import org.dronewatch.world.World;

/**
 * The strength of the echoes that a radar receives from drones in a world, and of the clutter that competes with them.
 * For use by one thread.
 */
final class RadarEcho {
    /**
     * What a radar receives from a drone.
     *
     * @param signal signal-to-noise ratio of its echo before the notch, dB; minus infinity without an echo
     * @param passed gain of the notch for this echo, 0 dB or less
     * @param clutter ratio of the clutter after the filters to the noise, dB; minus infinity without clutter
     * @param groundReflection contribution of the reflection from the ground to the signal, both ways, dB
     * @param edgeLoss loss of the signal at the edges of the site, both ways, dB
     */
    record Received(double signal, double passed, double clutter, double groundReflection, double edgeLoss) {
        private static final Received NOTHING =
                new Received(Double.NEGATIVE_INFINITY, 0.0, Double.NEGATIVE_INFINITY, 0.0, 0.0);

        /** Ratio of the signal to the sum of noise and clutter, dB. */
        double ratio() {
            return unfiltered() + passed;
        }

        /** Ratio of the signal to the sum of noise and clutter if the notch let everything pass, dB. */
        double unfiltered() {
            return signal - 10.0 * Math.log10(1.0 + Math.pow(10.0, 0.1 * clutter));
        }

        /** Ratio of the signal to the clutter alone, dB. */
        double signalToClutter() {
            return signal == Double.NEGATIVE_INFINITY ? signal : signal + passed - clutter;
        }
    }

    private final RadarSettings settings;
    private final FieldOfRegard field;
    private final Direction axis;
    private final World world;
    private final DoubleBinaryOperator budget;
    private final Optional<TwoRays> rays;
    private final Optional<RadioPath> edges;
    private final Optional<ClutterEcho> clutter;

    /** The echoes that a radar receives in a world. */
    RadarEcho(RadarSettings settings, FieldOfRegard field, World world) {
        this.settings = settings;
        this.field = field;
        this.axis = Direction.of(settings.aim().from(settings.position()));
        this.world = world;
        this.budget = settings.budget()
                .echo(settings.frequency(), settings.detection().pulses());
        this.rays = settings.groundReflection().map(ground -> new TwoRays(world, ground));
        this.edges = settings.diffraction() ? Optional.of(new RadioPath(world)) : Optional.empty();
        this.clutter = settings.clutter().map(one -> new ClutterEcho(settings, one, world));
    }

    /** Direction of the radar's aim. */
    Direction axis() {
        return axis;
    }

    /**
     * The echo of a drone.
     *
     * @param area its visible cross-section, m2; 0 if none is visible
     */
    Received of(Drone drone, double area) {
        return area == 0.0 ? Received.NOTHING : received(drone, area, edgeLoss(drone));
    }

    /**
     * The echo that a drone would have if nothing hid it.
     *
     * @param area its whole cross-section, above 0, m2
     */
    Received inTheOpen(Drone drone, double area) {
        return received(drone, area, 0.0);
    }

    /** The echoes of a drone and of the clutter in its resolution cell, with the attenuation by rain both ways. */
    private Received received(Drone drone, double area, double loss) {
        double range = range(drone);
        double reflection = groundReflection(drone);
        double rain = rainLoss(drone, range);
        double beam = 2.0 * beamGain(drone);
        double signal = budget.applyAsDouble(area, range) - rain + reflection + beam - loss;
        double residue = clutter(drone, range);
        double toNoise = residue > 0.0 ? budget.applyAsDouble(residue, range) - rain + beam : Double.NEGATIVE_INFINITY;
        return new Received(signal, passed(drone), toNoise, reflection, loss);
    }

    /**
     * The gain of the notch for a drone's echo, dB, 0 or less: it depends on radial speed for the body, while the echo
     * of the turning rotors passes in full.
     */
    private double passed(Drone drone) {
        if (settings.notch().isEmpty()) {
            return 0.0;
        }
        double ofBody = settings.notch().get().response(field.radialSpeed(drone));
        double rotors = rotorFraction(drone);
        return 10.0 * Math.log10(rotors + (1.0 - rotors) * ofBody);
    }

    /**
     * The response of the notch that a drone needs in order to be detected.
     *
     * @param decibels gain of the notch at which its echo is just strong enough, 0 dB or less
     */
    double neededResponse(Drone drone, double decibels) {
        double rotors = rotorFraction(drone);
        return (Math.pow(10.0, 0.1 * decibels) - rotors) / (1.0 - rotors);
    }

    private static double rotorFraction(Drone drone) {
        return drone.isPowered() ? drone.settings().radar().rotorFraction() : 0.0;
    }

    /** Radar cross-section of the clutter in a drone's resolution cell after the filters, m2; 0 without any. */
    private double clutter(Drone drone, double range) {
        if (clutter.isEmpty()) {
            return 0.0;
        }
        double azimuth = Direction.of(drone.origin().minus(settings.position())).azimuth();
        return clutter.get().residue(azimuth, range, elevation -> {
            Position way = new Direction(azimuth, elevation).unit().times(range);
            double amplitude = amplitude(drone, way);
            return amplitude * amplitude * amplitude * amplitude;
        });
    }

    /** Distance to a drone, above 0, m. */
    double range(Drone drone) {
        return Math.max(drone.origin().distance(settings.position()), Double.MIN_NORMAL);
    }

    /** Attenuation by rain on the path to a drone and back, dB. */
    private double rainLoss(Drone drone, double range) {
        double up = drone.origin().minus(settings.position()).z() / range;
        double elevation = Math.asin(Math.max(-1.0, Math.min(1.0, up)));
        double rain = Rain.attenuation(settings.frequency(), world.rain(), elevation, settings.polarisation());
        return 2.0 * rain * range;
    }

    /** Gain of the beam towards a drone relative to that on its axis, one way, dB; 0 without a beam. */
    double beamGain(Drone drone) {
        Direction target = Direction.of(drone.origin().minus(settings.position()));
        return settings.beam().map(beam -> beam.gain(axis, target, target)).orElse(0.0);
    }

    /** The loss of the wave at the edges of the site, both ways, dB; 0 where the visible fraction is used instead. */
    private double edgeLoss(Drone drone) {
        return edges.map(path -> 2.0 * path.obstacleLoss(drone.origin(), settings.position(), settings.frequency()))
                .orElse(0.0);
    }

    /** The model whose edge obstructs the path to a drone most; empty where none does, or where edges do not count. */
    Optional<Obstacle> obstacle(Drone drone) {
        return edges.flatMap(path -> path.obstacle(drone.origin(), settings.position(), settings.frequency()));
    }

    /**
     * The change in the echo due to the reflection from the ground, both ways, dB; 0 unless a reflecting ground is set.
     */
    private double groundReflection(Drone drone) {
        return rays.map(two -> 2.0
                        * two.weighted(
                                settings.position(),
                                drone.origin(),
                                settings.frequency(),
                                settings.polarisation() == Rain.Polarisation.VERTICAL,
                                way -> amplitude(drone, way)))
                .orElse(0.0);
    }

    /**
     * Amplitude of the antenna in the direction of a vector relative to that towards a drone; 0 outside the field of
     * view.
     */
    private double amplitude(Drone drone, Position way) {
        if (!field.contains(way)) {
            return 0.0;
        }
        if (settings.beam().isEmpty()) {
            return 1.0;
        }
        BeamPattern beam = settings.beam().get();
        Direction target = Direction.of(drone.origin().minus(settings.position()));
        double less = beam.gain(axis, target, Direction.of(way)) - beam.gain(axis, target, target);
        return Math.pow(10.0, less / 20.0);
    }
}
