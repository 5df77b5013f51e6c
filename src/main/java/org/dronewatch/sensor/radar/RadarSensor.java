package org.dronewatch.sensor.radar;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.RadarSignature;
import org.dronewatch.geometry.Position;
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
import org.dronewatch.sensor.radar.RadarEcho.Received;
import org.dronewatch.world.World;

/**
 * A radar. Its value is the ratio in dB of the drone's echo to the noise, or to the sum of noise and clutter if the
 * settings have clutter, after the notch if there is one; minus infinity for a drone outside its limits of position or
 * radial speed. For a drone that is partly or entirely hidden, the visible fraction of the cross-section is used (minus
 * infinity if nothing is visible) or, with {@code diffraction}, the wave diffracted around the edges of the site in
 * both directions.
 */
public final class RadarSensor implements AssessableSensor {
    private static final String UNIT = "dB";

    private final RadarSettings settings;
    private final FieldOfRegard field;

    private World world;
    private VisibleFraction visible;
    private Cover cover;
    private RadarEcho echoes;
    private final Map<RadarSignature, Decision> decisions = new HashMap<>();

    /** A radar with these settings. */
    public RadarSensor(RadarSettings settings) {
        this.settings = settings;
        this.field = new FieldOfRegard(settings);
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
            echoes = new RadarEcho(settings, field, site);
        }
    }

    @Override
    public Signal signal(World site, Drone drone, Optional<Pointing> pointing, RandomGenerator rayRandom) {
        enter(site);
        double echo = received(drone).ratio();
        Decision decision = decision(drone);
        return Signal.of(decision.probability(echo), echo, UNIT, decision.evenThreshold());
    }

    @Override
    public Explanation explainMiss(World site, Drone drone, Optional<Pointing> pointing) {
        enter(site);
        return field.miss(drone)
                .or(() -> notched(drone))
                .orElseGet(() -> settings.diffraction()
                        ? explainShadow(drone)
                        : cover.explain(drone, () -> visible.of(drone) == 0.0, () -> isDetectedInTheOpen(drone)));
    }

    /** {@inheritDoc} True outside the field of view or the limits of range, whatever the radial speed. */
    @Override
    public boolean isSameAtAllHeadings(World site, Drone drone, Optional<Pointing> pointing) {
        return !field.contains(drone.origin().minus(settings.position()));
    }

    /**
     * The explanation for a drone that would be detected if the notch let all of its echo pass: it is too slow for the
     * notch, or flies at a blind speed. Empty otherwise.
     */
    private Optional<Explanation> notched(Drone drone) {
        if (settings.notch().isEmpty()) {
            return Optional.empty();
        }
        Received received = received(drone);
        double threshold = decision(drone).evenThreshold();
        if (received.ratio() >= threshold || received.unfiltered() < threshold) {
            return Optional.empty();
        }
        double needed = echoes.neededResponse(drone, threshold - received.unfiltered());
        return Optional.of(settings.notch().get().miss(field.radialSpeed(drone), needed));
    }

    /**
     * The explanation if waves are diffracted around edges: a drone is hidden only if it would be detected without the
     * loss at the edges.
     */
    private Explanation explainShadow(Drone drone) {
        if (!isDetectedInTheOpen(drone)) {
            return Explanation.of(Cause.TOO_WEAK);
        }
        return cover.ofOrigin(drone)
                .or(() -> echoes.obstacle(drone))
                .map(Explanation::hiddenBy)
                .orElseGet(() -> Explanation.of(Cause.TOO_WEAK));
    }

    private boolean isDetectedInTheOpen(Drone drone) {
        double echo = echoes.inTheOpen(drone, crossSection(drone, 1.0)).ratio();
        return echo >= decision(drone).evenThreshold();
    }

    /**
     * The rule by which echoes of a drone are detected. It is kept for reuse, since it takes long to prepare if chance
     * decides.
     */
    private Decision decision(Drone drone) {
        return decisions.computeIfAbsent(drone.settings().radar(), settings.detection()::on);
    }

    /** The fraction of a drone that counts, 0 to 1; 0 for one that the radar does not look for. */
    private double visibleFraction(Drone drone) {
        if (field.miss(drone).isPresent()) {
            return 0.0;
        }
        return settings.diffraction() ? 1.0 : visible.of(drone);
    }

    private Received received(Drone drone) {
        return echoes.of(drone, crossSection(drone, visibleFraction(drone)));
    }

    private double crossSection(Drone drone, double fraction) {
        return fraction * drone.settings().radar().towards(aspect(drone));
    }

    private Observation look(Drone drone, Look look) {
        double fraction = visibleFraction(drone);
        double area = crossSection(drone, fraction);
        Received received = echoes.of(drone, area);
        double echo = received.ratio();
        Decision decision = decision(drone);

        Map<String, Double> figures = new LinkedHashMap<>();
        figures.put("radial_speed_m_per_s", field.radialSpeed(drone));
        figures.put("in_field", field.contains(drone.origin().minus(settings.position())) ? 1.0 : 0.0);
        figures.put("visible_share", settings.diffraction() && area > 0.0 ? visible.of(drone) : fraction);
        figures.put("cross_section_m2", area);
        figures.put(Observation.PROBABILITY, decision.probability(echo));
        addFigures(figures, drone, received);

        double threshold = decision.threshold(look.random(drone.id(), Look.DETECTION));
        Optional<Sighting> sighting = echo >= threshold ? Optional.of(sighting(drone, look)) : Optional.empty();
        return new Observation(
                look.id(settings.kind()),
                new GroundTruth(drone.id(), echoes.range(drone), look.time()),
                new Reading(echo, threshold, UNIT),
                figures,
                sighting);
    }

    /** Adds the figures of those effects beyond the bare echo that the settings include. */
    private void addFigures(Map<String, Double> figures, Drone drone, Received received) {
        if (settings.beam().isPresent()) {
            figures.put("beam_gain_db", echoes.beamGain(drone));
        }
        if (settings.diffraction()) {
            figures.put("diffraction_loss_db", received.edgeLoss());
        }
        if (settings.groundReflection().isPresent()) {
            figures.put("ground_reflection_db", received.groundReflection());
        }
        if (settings.notch().isPresent()) {
            figures.put("notch_db", received.passed());
        }
        if (settings.clutter().isPresent()) {
            figures.put("clutter_to_noise_db", received.clutter());
            figures.put("signal_to_clutter_db", received.signalToClutter());
        }
    }

    private Sighting sighting(Drone drone, Look look) {
        RandomGenerator random = look.random(drone.id(), Look.ERROR);
        return settings.accuracy()
                .sighting(settings.position(), drone.origin(), echoes.axis().elevation(), random);
    }

    /** The bearing of the radar relative to the drone's nose, clockwise as seen from above, rad. */
    private double aspect(Drone drone) {
        Position seen = drone.toModel(settings.position());
        return Math.atan2(seen.x(), seen.y());
    }

    /** The settings of this radar. */
    public RadarSettings settings() {
        return settings;
    }
}
