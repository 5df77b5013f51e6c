package org.dronewatch.analysis.field;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Stream;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.RadioLink;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.camera.PixelThreshold;
import org.dronewatch.sensor.optics.FieldOfView;
import org.dronewatch.sensor.optics.PictureSettings;
import org.dronewatch.sensor.radar.DopplerFilter;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.sensor.rf.RfSettings;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.world.SurfaceSettings;
import org.dronewatch.world.World;

/**
 * Causes by the order in which they are defined, from angles and distances, from every triangle of the site, and from
 * looks in a world in which nothing stands: none of it is found by the code that explains misses.
 */
final class BruteCauses {
    /** Fewer visible points than this share of all leave open whether a sensor sees anything of a drone. */
    private static final double FEW = 0.1;

    /** A radar sees a drone by points that are at most half-way from the middle of its box to the corners. */
    private static final double INNER = 0.5;

    private static final double EVEN_CHANCE = 0.5;

    /** Near a limit, rounding decides: as a fraction of a range, rad, or m/s. */
    private static final double ROUNDING = 1e-7;

    /** Edges that matter to a radio wave force it at most on such a detour, in wavelengths. */
    private static final double DETOUR = 2.0;

    private static final double LIGHT = 299_792_458.0;

    private static final double STEP = 1.0 / 250.0;

    private final PackagedSite site;
    private final BruteTriangles triangles;
    private final World open;
    private final Map<SensorSettings<?>, Sensor> eyes = new HashMap<>();

    BruteCauses(PackagedSite site) {
        this.site = site;
        World world = site.stage().world();
        this.triangles = new BruteTriangles(world);
        TriangleMesh nothing = TriangleMesh.of(new float[0], new int[0]);
        BackgroundNoise noise = world.backgroundNoise();
        this.open = new World(KDTree.of(nothing), noise, SurfaceSettings.DEFAULT, world.atmosphere())
                .withRain(world.rain())
                .withLight(world.light())
                .withNoiseSources(world.noiseSources());
    }

    /**
     * The cause of a miss, or several if brute force leaves it open which of them it is.
     *
     * @param id name of a sensor that has turned to the drone
     * @param seen what a look reports of it
     * @param probability as in the field, for microphones that draw other rays in each look
     */
    Set<Cause> of(String id, Drone drone, Optional<Observation> seen, double probability) {
        SensorSettings<?> sensor = Mounted.pointed(site.sensor(id), site.pointing(id, drone));
        Position vector = drone.origin().minus(sensor.position());
        if (!site.stage().world().isKnownEverywhere() && !triangles.isGroundBelow(sensor.position(), drone.origin())) {
            return EnumSet.of(Cause.UNKNOWN);
        }
        boolean isUncertain = probability > 0.0 && probability < 1.0;
        if (sensor.kind().equals("acoustic") && Math.abs(probability - EVEN_CHANCE) < STEP) {
            return EnumSet.allOf(Cause.class);
        }
        boolean isDetected = sensor.kind().equals("acoustic") && isUncertain
                ? probability >= EVEN_CHANCE
                : seen.filter(one -> one.probability() >= EVEN_CHANCE).isPresent();
        if (isDetected) {
            return EnumSet.of(Cause.DETECTED);
        }
        return outside(sensor, drone, vector).orElseGet(() -> obstructed(sensor, drone, seen));
    }

    /** Causes that follow from position, speed and emission alone; empty where none holds. */
    private Optional<Set<Cause>> outside(SensorSettings<?> sensor, Drone drone, Position vector) {
        if (sensor instanceof RadarSettings radar) {
            return ofRadar(radar, drone, vector);
        }
        if (sensor instanceof PictureSettings picture) {
            double beyond = beyondFrame(picture, vector);
            return Math.abs(beyond) < ROUNDING
                    ? Optional.of(EnumSet.allOf(Cause.class))
                    : beyond > 0.0 ? Optional.of(EnumSet.of(Cause.OUT_OF_VIEW)) : Optional.empty();
        }
        if (sensor instanceof RfSettings radio) {
            RadioLink link = drone.settings().radio();
            boolean isHeard = link.control() == RadioLink.Control.RADIO
                    && radio.recognised().contains(link.emission())
                    && link.frequency() >= radio.minFrequency()
                    && link.frequency() <= radio.maxFrequency();
            return isHeard ? Optional.empty() : Optional.of(EnumSet.of(Cause.SILENT));
        }
        return Optional.empty();
    }

    private Optional<Set<Cause>> ofRadar(RadarSettings radar, Drone drone, Position vector) {
        double range = vector.length();
        if (range < radar.minRange() || range > radar.maxRange()) {
            return Optional.of(EnumSet.of(Cause.OUT_OF_RANGE));
        }
        Position axis = radar.aim().from(radar.position());
        double aside = Math.abs(
                Math.IEEEremainder(Math.atan2(vector.x(), vector.y()) - Math.atan2(axis.x(), axis.y()), 2.0 * Math.PI));
        double above = Math.abs(Math.asin(vector.z() / range) - Math.asin(axis.z() / axis.length()));
        double beyond = Math.max(aside - 0.5 * radar.azimuthWidth(), above - 0.5 * radar.elevationWidth());
        double radial = Math.abs(Position.of(drone.velocity()).dot(vector)) / range;
        double fastest = Math.min(radar.maxSpeed(), radar.budget().migrationSpeed());
        if (Math.abs(beyond) < ROUNDING && radar.azimuthWidth() < 2.0 * Math.PI
                || radar.minSpeed() > 0.0 && Math.abs(radial - radar.minSpeed()) < ROUNDING
                || Math.abs(radial - fastest) < ROUNDING) {
            return Optional.of(EnumSet.allOf(Cause.class));
        }
        if (beyond > ROUNDING) {
            return Optional.of(EnumSet.of(Cause.OUT_OF_VIEW));
        }
        if (radar.notch().isEmpty() && radial < radar.minSpeed()) {
            return Optional.of(EnumSet.of(Cause.TOO_SLOW));
        }
        if (radial > fastest) {
            return Optional.of(EnumSet.of(Cause.TOO_FAST));
        }
        return radar.notch()
                .filter(notch ->
                        isDetected(withoutNotch(radar), drone, site.stage().world()))
                .map(notch -> EnumSet.of(isAtBlindSpeed(notch, radial) ? Cause.TOO_FAST : Cause.TOO_SLOW));
    }

    /** Whether a speed is nearer to a blind speed of a filter, at which its response is 0 again, than to 0. */
    private static boolean isAtBlindSpeed(DopplerFilter notch, double radial) {
        return notch instanceof DopplerFilter.Canceller canceller && radial > 0.5 * canceller.blindSpeed();
    }

    private static RadarSettings withoutNotch(RadarSettings radar) {
        return SettingsForm.with(radar, Map.of("notch", Optional.empty(), "minSpeed", 0.0));
    }

    /** By how much a direction is outside an image, as a fraction of half its side; below 0 within it. */
    private static double beyondFrame(PictureSettings picture, Position vector) {
        Position axis = picture.aim().from(picture.position());
        Position forward = axis.times(1.0 / axis.length());
        Position right = new Position(forward.y(), -forward.x(), 0.0);
        right = right.times(1.0 / right.length());
        Position up = new Position(
                right.y() * forward.z() - right.z() * forward.y(),
                right.z() * forward.x() - right.x() * forward.z(),
                right.x() * forward.y() - right.y() * forward.x());
        double ahead = vector.dot(forward);
        if (ahead <= 0.0) {
            return 1.0;
        }
        double half = Math.tan(0.5 * picture.fov());
        double perPixel =
                half / (0.5 * (picture.fovAxis() == FieldOfView.VERTICAL ? picture.height() : picture.width()));
        double aside = Math.abs(vector.dot(right)) / ahead / (0.5 * picture.width() * perPixel);
        double above = Math.abs(vector.dot(up)) / ahead / (0.5 * picture.height() * perPixel);
        return Math.max(aside, above) - 1.0;
    }

    /** Hidden, if nothing is visible or it would be detected if nothing stood in the way; otherwise too weak. */
    private Set<Cause> obstructed(SensorSettings<?> sensor, Drone drone, Optional<Observation> seen) {
        boolean isDetectedInTheOpen = isDetected(sensor, drone, open);
        boolean isSeen =
                sensor instanceof PictureSettings || sensor instanceof RadarSettings radar && !radar.diffraction();
        if (!isSeen) {
            return isDetectedInTheOpen ? ofWave(sensor, drone) : EnumSet.of(Cause.TOO_WEAK);
        }
        BruteTriangles.Sight sight = triangles.sight(sensor.position(), drone.origin(), drone.radius());
        Set<ModelRole> before = sight.before(drone.origin());
        if (before.isEmpty()) {
            return isDetectedInTheOpen ? hidden(aroundOrigin(sight, drone)) : EnumSet.of(Cause.TOO_WEAK);
        }
        if (isDetectedInTheOpen) {
            return hidden(before);
        }
        if (sensor instanceof CameraSettings camera) {
            // What is visible between the rays of the pixels is not seen.
            return pixels(camera, drone) == 0.0 ? hidden(before) : EnumSet.of(Cause.TOO_WEAK);
        }
        return partly(sight, points(drone, sensor instanceof RadarSettings ? INNER : 1.0), seen, before);
    }

    /** A drone that would be missed in the open is hidden if nothing of it is visible, and otherwise too weak. */
    private static Set<Cause> partly(
            BruteTriangles.Sight sight, List<Position> points, Optional<Observation> seen, Set<ModelRole> before) {
        int visible = sight.visible(points);
        if (visible > FEW * points.size()) {
            return EnumSet.of(Cause.TOO_WEAK);
        }
        // Of what is visible of so little, a sensor may notice nothing.
        OptionalDouble noticed = seen.map(Observation::figures).stream()
                .flatMap(figures -> Stream.of("pixels", "visible_share").map(figures::get))
                .filter(Objects::nonNull)
                .mapToDouble(Double::doubleValue)
                .findFirst();
        if (noticed.isPresent()) {
            return noticed.getAsDouble() == 0.0 ? hidden(before) : EnumSet.of(Cause.TOO_WEAK);
        }
        Set<Cause> causes = hidden(before);
        if (visible > 0) {
            causes.add(Cause.TOO_WEAK);
        }
        return causes;
    }

    /** How many pixels of a picture show a drone. */
    private double pixels(CameraSettings camera, Drone drone) {
        CameraSettings counting = SettingsForm.with(camera, "detection", PixelThreshold.DEFAULT);
        Look look = Look.of(site.settings().run().seed(), "pixels", 0, 0.0);
        return counting.create().observe(site.stage().world(), List.of(drone), look).stream()
                .mapToDouble(Observation::value)
                .findFirst()
                .orElse(0.0);
    }

    /**
     * Waves go round edges: what stands in the way hides a drone that would be detected without it, and so does, of a
     * radio wave, an edge beside the line of sight.
     */
    private Set<Cause> ofWave(SensorSettings<?> sensor, Drone drone) {
        boolean isSound = sensor.kind().equals("acoustic");
        if (!isSound && drone.settings().radio().pilot().isPresent()) {
            return EnumSet.range(Cause.HIDDEN_BY_TERRAIN, Cause.TOO_WEAK);
        }
        double detour = isSound ? 0.0 : DETOUR * LIGHT / frequency(sensor, drone);
        double aside = 0.5 * Math.sqrt(detour * (2.0 * drone.distance(sensor.position()) + detour));
        BruteTriangles.Sight sight =
                triangles.sight(sensor.position(), drone.origin(), Math.max(drone.radius(), aside));
        Set<ModelRole> before = sight.before(drone.origin());
        if (isSound || !before.isEmpty()) {
            return hidden(before);
        }
        Set<Cause> causes = hidden(sight.beside(drone.origin(), detour));
        if (isDetected(withoutReflection(sensor), drone, site.stage().world())) {
            // The reflection from the ground extinguishes the wave, or an edge does so together with it.
            causes.add(Cause.TOO_WEAK);
        }
        return causes;
    }

    private static SensorSettings<?> withoutReflection(SensorSettings<?> sensor) {
        return sensor instanceof RfSettings radio
                ? SettingsForm.with(radio, "groundReflection", Optional.empty())
                : SettingsForm.with((RadarSettings) sensor, "groundReflection", Optional.empty());
    }

    private static double frequency(SensorSettings<?> sensor, Drone drone) {
        return sensor instanceof RadarSettings radar
                ? radar.frequency()
                : drone.settings().radio().frequency();
    }

    /** What hides corners of a drone whose middle is in sight. */
    private static Set<ModelRole> aroundOrigin(BruteTriangles.Sight sight, Drone drone) {
        Set<ModelRole> roles = EnumSet.noneOf(ModelRole.class);
        TriangleMesh mesh = drone.tree().mesh();
        for (int i = 0; i < mesh.vertexCount(); i++) {
            roles.addAll(sight.before(drone.toWorld(new Position(
                    mesh.vertexCoordinate(i, 0), mesh.vertexCoordinate(i, 1), mesh.vertexCoordinate(i, 2)))));
        }
        return roles;
    }

    /** The middles of those of a drone's triangles that are in its box, scaled about its middle. */
    private static List<Position> points(Drone drone, double scale) {
        TriangleMesh mesh = drone.tree().mesh();
        List<Position> points = new ArrayList<>();
        int step = Math.max(1, mesh.triangleCount() / 200);
        for (int i = 0; i < mesh.triangleCount(); i += step) {
            double[] middle = new double[3];
            for (int k = 0; k < 9; k++) {
                middle[k % 3] += mesh.coordinate(i, k / 3, k % 3) / 3.0;
            }
            Position point = new Position(middle[0], middle[1], middle[2]);
            if (isInside(drone.modelBounds(), scale, point)) {
                points.add(drone.toWorld(point));
            }
        }
        return points;
    }

    private static boolean isInside(AABB box, double scale, Position point) {
        return isBetween(box.minX(), box.maxX(), scale, point.x())
                && isBetween(box.minY(), box.maxY(), scale, point.y())
                && isBetween(box.minZ(), box.maxZ(), scale, point.z());
    }

    private static boolean isBetween(double low, double high, double scale, double at) {
        return Math.abs(at - 0.5 * (low + high)) <= 0.5 * scale * (high - low);
    }

    private static Set<Cause> hidden(Set<ModelRole> roles) {
        Set<Cause> causes = EnumSet.noneOf(Cause.class);
        roles.forEach(role -> causes.add(Cause.valueOf("HIDDEN_BY_" + role)));
        return causes.isEmpty() ? EnumSet.of(Cause.TOO_WEAK) : causes;
    }

    private boolean isDetected(SensorSettings<?> sensor, Drone drone, World world) {
        Sensor eye = eyes.size() < 100 ? eyes.computeIfAbsent(sensor, SensorSettings::create) : sensor.create();
        Look look = Look.of(site.settings().run().seed(), "open", 0, 0.0);
        return eye.observe(world, List.of(drone), look).stream().anyMatch(seen -> seen.probability() >= EVEN_CHANCE);
    }
}
