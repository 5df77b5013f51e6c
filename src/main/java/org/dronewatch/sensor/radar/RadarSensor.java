package org.dronewatch.sensor.radar;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.DoubleBinaryOperator;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.RadarSignature;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sensor.AssessableSensor;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Cover;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.GroundTruth;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.Signal;
import org.dronewatch.sensor.radar.RadarDetection.Decision;
import org.dronewatch.sensor.radio.RadioPath;
import org.dronewatch.sensor.radio.TwoRays;
import org.dronewatch.world.World;

/**
 * A radar. Its value is the signal-to-noise ratio of the drone's echo; minus infinity for a drone that it does not look
 * for, because of the drone's position or radial speed, and for one that is wholly hidden. Of a partly hidden drone,
 * the visible fraction of the cross-section counts, or, where the settings ask for it, the wave that is diffracted
 * round the edges of the site on both ways.
 */
public final class RadarSensor implements AssessableSensor {
    private static final String UNIT = "dB";

    private final RadarSettings settings;
    private final FieldOfRegard field;
    private final Direction axis;

    private World world;
    private VisibleFraction visible;
    private Cover cover;
    private Optional<TwoRays> rays = Optional.empty();
    private Optional<RadioPath> edges = Optional.empty();
    private final DoubleBinaryOperator budget;
    private final Map<RadarSignature, Decision> decisions = new HashMap<>();

    /** A radar with these settings. */
    public RadarSensor(RadarSettings settings) {
        this.settings = settings;
        this.field = new FieldOfRegard(settings);
        this.axis = Direction.of(settings.aim().from(settings.position()));
        this.budget = settings.budget()
                .echo(settings.frequency(), settings.detection().pulses());
    }

    @Override
    public List<Observation> observe(World site, List<Drone> drones, Look look) {
        enter(site);
        return drones.stream().map(drone -> look(drone, look)).toList();
    }

    private void enter(World site) {
        if (site != world) {
            world = site;
            visible = new VisibleFraction(site, settings.position());
            cover = new Cover(site, settings.position());
            rays = settings.groundReflection().map(ground -> new TwoRays(site, ground));
            edges = settings.diffraction() ? Optional.of(new RadioPath(site)) : Optional.empty();
        }
    }

    @Override
    public Signal signal(World site, Drone drone, Optional<Pointing> pointing, RandomGenerator rayRandom) {
        enter(site);
        return signal(drone, crossSection(drone, visibleFraction(drone)));
    }

    @Override
    public Explanation explainMiss(World site, Drone drone, Optional<Pointing> pointing) {
        enter(site);
        return field.miss(drone).orElseGet(() -> edges.map(path -> explainShadow(drone, path))
                .orElseGet(
                        () -> cover.explain(drone, () -> visible.of(drone) == 0.0, () -> isDetectedInTheOpen(drone))));
    }

    /** Where waves go round edges, a drone is hidden only if it would be detected without their loss. */
    private Explanation explainShadow(Drone drone, RadioPath path) {
        if (!isDetectedInTheOpen(drone)) {
            return Explanation.of(Cause.TOO_WEAK);
        }
        return cover.ofOrigin(drone)
                .or(() -> path.obstacle(drone.origin(), settings.position(), settings.frequency()))
                .map(Explanation::hiddenBy)
                .orElseGet(() -> Explanation.of(Cause.TOO_WEAK));
    }

    private boolean isDetectedInTheOpen(Drone drone) {
        return echo(drone, crossSection(drone, 1.0)) >= decision(drone).evenThreshold();
    }

    /** What the edges of the site take of the wave, both ways, dB; 0 where the visible fraction counts instead. */
    private double edgeLoss(Drone drone) {
        return edges.map(path -> 2.0 * path.obstacleLoss(drone.origin(), settings.position(), settings.frequency()))
                .orElse(0.0);
    }

    /** The signal of a drone that the radar looks for, with its visible cross-section, m2. */
    private Signal signal(Drone drone, double area) {
        double echo = area == 0.0 ? Double.NEGATIVE_INFINITY : echo(drone, area) - edgeLoss(drone);
        Decision decision = decision(drone);
        return Signal.of(decision.probability(echo), echo, UNIT, decision.evenThreshold());
    }

    /** How echoes of a drone are decided on; kept, as it takes long to prepare where chance decides. */
    private Decision decision(Drone drone) {
        return decisions.computeIfAbsent(drone.settings().radar(), settings.detection()::on);
    }

    /** The fraction of a drone that counts, 0 to 1; 0 for one that the radar does not look for. */
    private double visibleFraction(Drone drone) {
        if (field.miss(drone).isPresent()) {
            return 0.0;
        }
        return edges.isPresent() ? 1.0 : visible.of(drone);
    }

    private double crossSection(Drone drone, double fraction) {
        return fraction * drone.settings().radar().towards(aspect(drone));
    }

    private Observation look(Drone drone, Look look) {
        Position position = drone.origin();
        double fraction = visibleFraction(drone);
        double area = crossSection(drone, fraction);
        double loss = area == 0.0 ? 0.0 : edgeLoss(drone);
        double echo = echo(drone, area) - loss;

        Decision decision = decision(drone);
        Map<String, Double> figures = new LinkedHashMap<>();
        figures.put("radial_speed_m_per_s", field.radialSpeed(drone));
        figures.put("in_field", field.contains(position.minus(settings.position())) ? 1.0 : 0.0);
        figures.put("visible_share", edges.isPresent() && area > 0.0 ? visible.of(drone) : fraction);
        figures.put("cross_section_m2", area);
        figures.put(Observation.PROBABILITY, decision.probability(echo));
        settings.beam().ifPresent(beam -> {
            Direction target = Direction.of(position.minus(settings.position()));
            figures.put("beam_gain_db", beam.gain(axis, target, target));
        });
        if (edges.isPresent()) {
            figures.put("diffraction_loss_db", loss);
        }
        if (rays.isPresent()) {
            figures.put("ground_reflection_db", area == 0.0 ? 0.0 : groundReflection(drone));
        }
        double threshold = decision.threshold(look.random(drone.id(), Look.DETECTION));
        Optional<Sighting> sighting = echo >= threshold
                ? Optional.of(settings.accuracy()
                        .sighting(settings.position(), position, axis.elevation(), look.random(drone.id(), Look.ERROR)))
                : Optional.empty();
        return new Observation(
                look.id(settings.kind()),
                new GroundTruth(drone.id(), range(drone), look.time()),
                new Reading(echo, threshold, UNIT),
                figures,
                sighting);
    }

    private double range(Drone drone) {
        return Math.max(drone.origin().distance(settings.position()), Double.MIN_NORMAL);
    }

    /** Signal-to-noise ratio of an echo, dB, with the attenuation by rain both ways. */
    private double echo(Drone drone, double area) {
        if (area == 0.0) {
            return Double.NEGATIVE_INFINITY;
        }
        Position vector = drone.origin().minus(settings.position());
        double range = range(drone);
        double elevation = Math.asin(Math.max(-1.0, Math.min(1.0, vector.z() / range)));
        double rain = Rain.attenuation(settings.frequency(), world.rain(), elevation, settings.polarisation());
        double clear = budget.applyAsDouble(area, range) - 2.0 * rain * range + groundReflection(drone);
        if (settings.beam().isEmpty()) {
            return clear;
        }
        Direction target = Direction.of(vector);
        return clear + 2.0 * settings.beam().get().gain(axis, target, target);
    }

    /** What the reflection from the ground adds to the echo, both ways, dB; 0 unless it is set. */
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

    /** Where the radar is, clockwise from the drone's nose as seen from above. */
    private double aspect(Drone drone) {
        Position seen = drone.toModel(settings.position());
        return Math.atan2(seen.x(), seen.y());
    }

    /** The settings of this radar. */
    public RadarSettings settings() {
        return settings;
    }
}
