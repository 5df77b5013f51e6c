package org.dronewatch.sensor.camera;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import java.util.function.DoubleToIntFunction;
import java.util.function.IntPredicate;
import java.util.function.Predicate;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.AssessmentBounds;
import org.dronewatch.sensor.BoundingSensor;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Cover;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.GroundTruth;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.ProbabilityResolution;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.Signal;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.sensor.optics.DepthImage;
import org.dronewatch.sensor.optics.DronePicture;
import org.dronewatch.sensor.optics.DronePixels;
import org.dronewatch.world.World;

/**
 * A camera for visible light. Keeps its most recent image, and scratch memory for drones: for use by one thread at a
 * time.
 */
public final class CameraSensor implements BoundingSensor {
    /** If there are fewer pixels than this, all of them are counted without checking whether some suffice. */
    private static final int FEW_PIXELS = 256;

    private final CameraSettings settings;
    private final DronePicture ownAim;

    private DronePicture picture;
    private Optional<Pointing> pointing = Optional.empty();
    private World world;
    private Cover cover;
    private CameraSignal signals;
    private CameraBounds bounds;

    /** A camera with the given settings. */
    public CameraSensor(CameraSettings settings) {
        this(settings, DronePicture.atRest(new CameraObject(settings)));
    }

    private CameraSensor(CameraSettings settings, DronePicture ownAim) {
        this.settings = settings;
        this.ownAim = ownAim;
        this.picture = ownAim;
    }

    @Override
    public CameraSensor sibling() {
        return new CameraSensor(settings, ownAim.sibling());
    }

    /** {@inheritDoc} Counts the pixels of each drone that are not hidden by the world or by other drones. */
    @Override
    public List<Observation> observe(World site, List<Drone> drones, Look look) {
        turn(site, look.pointing());
        picture.draw(world, drones);
        List<Observation> observations = new ArrayList<>(drones.size());
        for (int i = 0; i < drones.size(); i++) {
            observations.add(observe(drones.get(i), picture.pixels(i), look));
        }
        return observations;
    }

    private void turn(World site, Optional<Pointing> where) {
        if (site != world) {
            world = site;
            cover = new Cover(site, settings.position());
            signals = new CameraSignal(settings, site);
            bounds = new CameraBounds(site, signals, cover);
        }
        if (!pointing.equals(where)) {
            pointing = where;
            picture = pointing.map(to -> turned(new CameraObject(settings.pointed(to))))
                    .orElse(ownAim);
        }
    }

    private DronePicture turned(CameraObject to) {
        return picture == ownAim ? new DronePicture(to) : picture.turned(to);
    }

    @Override
    public Signal signal(World site, Drone drone, Optional<Pointing> where, RandomGenerator rayRandom) {
        turn(site, where);
        return signal(drone, pixels -> false);
    }

    private Signal signal(Drone drone, IntPredicate enough) {
        picture.draw(world, drone, enough);
        return signal(view(drone, picture.pixels(0)));
    }

    @Override
    public Assessment assess(World site, Drone drone, Optional<Pointing> where, RandomGenerator rayRandom) {
        turn(site, where);
        return assess(drone, pixels -> false);
    }

    /** {@inheritDoc} A drone near the camera covers many thousands of pixels, of which a few suffice for a decision. */
    @Override
    public Assessment assessCoarsely(
            World site,
            Drone drone,
            Optional<Pointing> where,
            RandomGenerator rayRandom,
            ProbabilityResolution resolution) {
        turn(site, where);
        double most = signal(view(drone, picture.mostPixels(world, drone))).probability();
        double sufficient = most < 1.0 ? resolution.high() : 1.0;
        return assess(drone, enough(drone, signal -> signal.probability() >= sufficient && signal.isDetected()));
    }

    private Assessment assess(Drone drone, IntPredicate enough) {
        Signal signal = signal(drone, enough);
        int pixels = picture.pixels(0);
        return new Assessment(
                signal, signal.isDetected() ? Explanation.DETECTED : explainMiss(drone, () -> pixels > 0));
    }

    @Override
    public Explanation explainMiss(World site, Drone drone, Optional<Pointing> where) {
        turn(site, where);
        return explainMiss(drone, () -> isInPicture(drone));
    }

    private Explanation explainMiss(Drone drone, BooleanSupplier isInPicture) {
        Position vector = drone.origin().minus(settings.position());
        return picture.camera().outline().contains(vector)
                ? cover.explain(drone, () -> !isInPicture.getAsBoolean(), () -> isDetectedInTheOpen(drone))
                : Explanation.of(Cause.OUT_OF_VIEW);
    }

    @Override
    public Optional<AssessmentBounds> boundAtAllHeadings(
            World site, Drone drone, Position at, Optional<Pointing> where) {
        turn(site, where);
        return bounds.atAllHeadings(picture, drone, at);
    }

    @Override
    public Optional<AssessmentBounds> bound(
            World site, Drone drone, FlightState state, Optional<Pointing> where, DoubleToIntFunction steps) {
        turn(site, where);
        return settings.detection().growsWithPixels()
                ? bounds.of(picture, drone, state, pointing, steps)
                : Optional.empty();
    }

    @Override
    public double greatestMarginDb(World site, Drone drone, FlightState state, Optional<Pointing> where) {
        turn(site, where);
        return settings.detection().growsWithPixels()
                ? bounds.greatestMarginDb(picture, drone, state, pointing)
                : Double.POSITIVE_INFINITY;
    }

    /**
     * {@inheritDoc} A drone that is outside the image whatever its heading has no pixels; the cause depends on its
     * position alone.
     */
    @Override
    public boolean isSameAtAllHeadings(World site, Drone drone, Optional<Pointing> where) {
        turn(site, where);
        Position at = drone.origin();
        return picture.camera().isOutside(at.x(), at.y(), at.z(), drone.radius());
    }

    /**
     * {@inheritDoc} True if the detection function only counts pixels, since their number does not depend on the speed.
     */
    @Override
    public boolean isSameAtAllSpeeds() {
        return settings.detection().countsPixelsOnly();
    }

    private boolean isInPicture(Drone drone) {
        picture.draw(world, drone, pixels -> true);
        return picture.pixels(0) > 0;
    }

    private boolean isDetectedInTheOpen(Drone drone) {
        return signal(view(drone, picture.pixelsInTheOpen(drone, enough(drone, Signal::isDetected))))
                .isDetected();
    }

    /**
     * Whether a number of pixels gives a sufficient signal; false if there are few pixels, since all of them are
     * counted then.
     */
    private IntPredicate enough(Drone drone, Predicate<Signal> isSufficient) {
        if (!settings.detection().growsWithPixels() || picture.mostPixels(world, drone) < FEW_PIXELS) {
            return pixels -> false;
        }
        DroneView one = view(drone, 1);
        return pixels -> isSufficient.test(signal(one.withPixels(pixels)));
    }

    private Signal signal(DroneView view) {
        return signals.of(view);
    }

    private Observation observe(Drone drone, int pixels, Look look) {
        DroneView view = view(drone, pixels);
        Signal signal = signal(view);
        OptionalDouble probability = settings.detection().probability(view);
        Reading reading = new Reading(signal.quantity(), threshold(drone, look, signal.probability()), signal.unit());
        boolean sighted = reading.isDetected() || pixels >= settings.lockPixels() && isFollowed(drone, view, look);
        return new Observation(
                look.id(settings.kind()),
                new GroundTruth(drone.id(), view.range(), look.time()),
                reading,
                probability.isPresent() ? Map.of(Observation.PROBABILITY, probability.getAsDouble()) : Map.of(),
                sighted ? Optional.of(settings.sighting(drone.origin(), pixels, picture.camera())) : Optional.empty());
    }

    /** The threshold that the value must reach in one frame. */
    private double threshold(Drone drone, Look look, double probability) {
        return isWatched()
                ? look.observerThreshold(drone.id(), settings.rate(), probability)
                : settings.detection().threshold(look.random(drone.id(), Look.DETECTION));
    }

    private boolean isWatched() {
        return settings.chance() == Chance.PER_ENCOUNTER;
    }

    /** Whether a drone with enough pixels is seen well enough for a positioner to follow it. */
    private boolean isFollowed(Drone drone, DroneView view, Look look) {
        OptionalDouble value = settings.detection().followingValue(view);
        if (value.isEmpty()) {
            return true;
        }
        double threshold = isWatched()
                ? look.followingThreshold(drone.id(), settings.rate(), value.getAsDouble())
                : threshold(drone, look, value.getAsDouble());
        return value.getAsDouble() >= threshold;
    }

    private DroneView view(Drone drone, int pixels) {
        return signals.view(
                drone.origin(),
                Position.of(drone.velocity()),
                pixels,
                pointing,
                picture.camera().focalLength());
    }

    /**
     * The whole image along the aim in the camera's settings, traced on the {@link org.dronewatch.parallel.Workers} of
     * the calling thread; the same for any number of them.
     */
    public DepthImage depthImage(World site, List<Drone> drones) {
        return ownAim.depthImage(site, drones);
    }

    /**
     * For each drone in the given order, its significant pixels along the aim in the camera's settings, and which of
     * these show the drone.
     */
    public List<DronePixels> pixels(World site, List<Drone> drones) {
        return ownAim.pixels(site, drones);
    }

    /** The number of pixels that show a drone along the aim in the camera's settings, if it is the only drone. */
    public int pixels(World site, Drone drone) {
        ownAim.draw(site, List.of(drone));
        return ownAim.pixels(0);
    }

    /** Pose and projection along the aim in the camera's settings. */
    public CameraObject camera() {
        return ownAim.camera();
    }

    /** The settings of this camera. */
    public CameraSettings settings() {
        return settings;
    }
}
