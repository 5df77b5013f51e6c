package org.dronewatch.sensor.rf;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.RadioLink;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.AssessableSensor;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.Signal;
import org.dronewatch.sensor.radio.LinearPolarisation;
import org.dronewatch.sensor.radio.RadioPath;
import org.dronewatch.sensor.radio.TwoRays;
import org.dronewatch.world.Obstacle;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * A radio receiver. Its value is the signal-to-noise ratio in dB of the stronger of a drone's own emission and its
 * pilot's; minus infinity for a silent drone, for a carrier outside its frequency range, for an emission that it cannot
 * recognise as a drone's, and in looks that intercept no burst. Keeps scratch memory: for use by one thread at a time.
 */
public final class RfSensor implements AssessableSensor {
    private static final String UNIT = "dB";

    /** The purpose of the numbers that decide whether a look intercepts the pilot. */
    private static final String PILOT = "pilot";

    private final RfSettings settings;
    private RadioPath path;
    private Optional<TwoRays> rays = Optional.empty();
    private Visibility visibility;

    /**
     * The link whose pilot was received last, with its signal-to-noise ratio, which does not change: pilots do not
     * move, wherever the drone is.
     */
    private Optional<RadioLink> known = Optional.empty();

    private double ofKnownPilot;

    /** A receiver with these settings. */
    public RfSensor(RfSettings settings) {
        this.settings = settings;
    }

    @Override
    public List<Observation> observe(World world, List<Drone> drones, Look look) {
        enter(world);
        return drones.stream().map(drone -> listen(drone, look)).toList();
    }

    private void enter(World world) {
        if (path == null || path.world() != world) {
            path = new RadioPath(world);
            rays = settings.groundReflection().map(ground -> new TwoRays(world, ground));
            visibility = new Visibility(world);
            known = Optional.empty();
        }
    }

    @Override
    public Signal signal(World world, Drone drone, Optional<Pointing> pointing, RandomGenerator rayRandom) {
        enter(world);
        Reception reception = reception(drone, ofDrone(drone), ofPilot(drone));
        double median = reception.median();
        return reception.isCertain()
                ? Signal.certain(median, UNIT, settings.threshold())
                : Signal.of(reception.probability(settings.threshold()), median, UNIT, settings.threshold());
    }

    /** The reception on which chance has to decide, for signals with these signal-to-noise ratios, dB. */
    private Reception reception(Drone drone, double ofDrone, double ofPilot) {
        RadioLink link = drone.settings().radio();
        double occupancy = settings.occupiedAt(link.frequency())
                .map(named -> named.getValue().occupancy())
                .orElse(0.0);
        return new Reception(ofDrone, ofPilot, settings.interception(link), settings.rise(link.frequency()), occupancy);
    }

    /**
     * {@inheritDoc} Since radio waves are diffracted around edges, a drone behind an obstacle counts as hidden only if
     * the stronger of its two emissions would be received without the diffraction loss. A drone that would be received
     * only on the axis of the beam counts as out of view.
     */
    @Override
    public Explanation explainMiss(World world, Drone drone, Optional<Pointing> pointing) {
        enter(world);
        RadioLink link = drone.settings().radio();
        if (!settings.hears(link)) {
            return settings.silence(link);
        }
        double onAxis = pastEdges(link, drone.origin(), link.power(), way -> 1.0);
        double pilotOnAxis = link.pilot()
                .map(pilot -> pastEdges(link, pilot, link.pilotPower(), way -> 1.0))
                .orElse(Double.NEGATIVE_INFINITY);
        if (reception(drone, onAxis, pilotOnAxis).median() < settings.threshold()) {
            return Explanation.of(Cause.TOO_WEAK);
        }
        double ofDrone = inBeam(link, drone.origin(), link.power());
        double ofPilot = link.pilot()
                .map(pilot -> inBeam(link, pilot, link.pilotPower()))
                .orElse(Double.NEGATIVE_INFINITY);
        if (reception(drone, ofDrone, ofPilot).median() < settings.threshold()) {
            return Explanation.of(Cause.OUT_OF_VIEW);
        }
        Position emitter = ofPilot > ofDrone ? link.pilot().orElseThrow() : drone.origin();
        Optional<Obstacle> before = visibility.obstacle(settings.position(), emitter);
        return before.or(() -> path.obstacle(emitter, settings.position(), link.frequency()))
                .map(Explanation::hiddenBy)
                .orElseGet(() -> Explanation.of(Cause.TOO_WEAK));
    }

    /** {@inheritDoc} Emissions are the same in all directions, and at every speed. */
    @Override
    public boolean isSameAtAllHeadings(World world, Drone drone, Optional<Pointing> pointing) {
        return true;
    }

    private Observation listen(Drone drone, Look look) {
        Reception reception = reception(drone, ofDrone(drone), ofPilot(drone));
        double rise = rise(drone, reception, look);
        boolean hearsDrone = isIntercepted(reception, look.random(drone.id(), Look.DETECTION));
        boolean hearsPilot = isIntercepted(reception, look.random(drone.id(), PILOT));
        double ofDrone = hearsDrone ? reception.drone() - rise : Double.NEGATIVE_INFINITY;
        double ofPilot = hearsPilot ? reception.pilot() - rise : Double.NEGATIVE_INFINITY;
        Map<String, Double> figures = new LinkedHashMap<>();
        figures.put("drone_snr_db", ofDrone);
        figures.put("pilot_snr_db", ofPilot);
        if (settings.beam().isPresent()) {
            figures.put("beam_gain_db", beamGain(drone.origin()));
        }
        if (!reception.isCertain()) {
            figures.put(Observation.PROBABILITY, reception.probability(settings.threshold()));
            figures.put("interference_db", rise);
        }
        return new Observation(
                        look.id(settings.kind()),
                        drone.id(),
                        drone.distance(settings.position()),
                        new Reading(Math.max(ofDrone, ofPilot), settings.threshold(), UNIT))
                .withFigures(figures);
    }

    private static boolean isIntercepted(Reception reception, RandomGenerator random) {
        return reception.interception() == 1.0 || random.nextDouble() < reception.interception();
    }

    /** The rise of the noise due to others in this look, dB; the same for all drones in their band. */
    private double rise(Drone drone, Reception reception, Look look) {
        if (reception.occupancy() == 0.0) {
            return 0.0;
        }
        String band = settings.occupiedAt(drone.settings().radio().frequency())
                .orElseThrow()
                .getKey();
        RandomGenerator random = look.random("", "occupied " + band);
        return random.nextDouble() < reception.occupancy() ? reception.rise() : 0.0;
    }

    private double ofDrone(Drone drone) {
        RadioLink link = drone.settings().radio();
        return ratio(link, drone.origin(), link.power());
    }

    private double ofPilot(Drone drone) {
        RadioLink link = drone.settings().radio();
        if (known.filter(link::equals).isEmpty()) {
            ofKnownPilot = link.pilot()
                    .map(pilot -> ratio(link, pilot, link.pilotPower()))
                    .orElse(Double.NEGATIVE_INFINITY);
            known = Optional.of(link);
        }
        return ofKnownPilot;
    }

    /** Signal-to-noise ratio of an emission from a position, dB. */
    private double ratio(RadioLink link, Position from, double power) {
        if (!settings.hears(link)) {
            return Double.NEGATIVE_INFINITY;
        }
        double edges = path.obstacleLoss(from, settings.position(), link.frequency());
        double beyondClutter = settings.clutterIncludesEdges() ? Math.max(0.0, edges - settings.clutter()) : edges;
        double loss = RadioPath.freeSpaceLoss(distance(from), link.frequency()) + beyondClutter + settings.clutter();
        double received = power + settings.gain() + beamGain(from);
        return received - loss - settings.noise(link.frequency()) + groundReflection(link, from, relativeTo(from));
    }

    /**
     * The change in the signal due to the reflection from the ground, dB; 0 unless a reflecting ground is set.
     *
     * @param weight amplitude with which the antenna receives from a direction, relative to that of the direct wave
     */
    private double groundReflection(RadioLink link, Position from, ToDoubleFunction<Position> weight) {
        boolean isVertical = settings.polarisation() == LinearPolarisation.VERTICAL;
        return rays.map(two -> two.weighted(settings.position(), from, link.frequency(), isVertical, weight))
                .orElse(0.0);
    }

    private ToDoubleFunction<Position> relativeTo(Position emitter) {
        double gain = beamGain(emitter);
        return way -> Math.pow(10.0, 0.05 * (settings.beamGain(way) - gain));
    }

    /** Gain of the antenna towards a position relative to that on the axis of its beam, dB. */
    private double beamGain(Position emitter) {
        Position towards = emitter.minus(settings.position());
        return towards.length() > 0.0 ? settings.beamGain(towards) : 0.0;
    }

    /** The signal-to-noise ratio that an emission would have if no edge weakened the direct wave, dB. */
    private double inBeam(RadioLink link, Position from, double power) {
        return pastEdges(link, from, power, relativeTo(from)) + beamGain(from);
    }

    /** The same ratio for an emission on the axis of the antenna, dB; see {@link #groundReflection} for the weight. */
    private double pastEdges(RadioLink link, Position from, double power, ToDoubleFunction<Position> weight) {
        double loss = RadioPath.freeSpaceLoss(distance(from), link.frequency()) + settings.clutter();
        return power
                - loss
                + (settings.gain() - settings.noise(link.frequency()))
                + groundReflection(link, from, weight);
    }

    /**
     * The distance for the formula of free-space loss, m. The formula does not hold in the near field: distances below
     * a metre count as a metre.
     */
    private double distance(Position from) {
        return Math.max(1.0, from.distance(settings.position()));
    }

    /** The settings of this receiver. */
    public RfSettings settings() {
        return settings;
    }
}
