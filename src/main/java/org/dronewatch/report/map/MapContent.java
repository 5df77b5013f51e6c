package org.dronewatch.report.map;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.fusion.Alert;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.fusion.ProtectedZone;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.render.canvas.KindColours;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.Outlined;
import org.dronewatch.sensor.SensorSettings;

/** What a map of a run shows: its first run, if there were several. */
final class MapContent implements DrawnFeatures {
    /** Maximum number of line segments of a flight, all of the same duration. */
    static final int STEPS = 300;

    private static final Color ZONE = new Color(0xc0392b);

    private final SceneResult result;
    private final RunResult run;
    private final SceneSettings settings;
    private final Origin origin;
    private final Geodesy geodesy;
    private final BuildingFeatures outlines;
    private final KindColours colours;
    private final Stage stage;

    MapContent(SceneResult result, Stage stage, Origin origin) {
        this.stage = stage;
        this.result = result;
        this.run = result.runs().get(0);
        this.settings = run.settings();
        this.origin = origin;
        this.geodesy = new Geodesy(origin);
        this.outlines = new BuildingFeatures(geodesy, origin);
        this.colours = KindColours.of(settings.enabledSensors().values());
    }

    /** The scene's name. */
    @Override
    public String title() {
        return result.scene();
    }

    /** A description of the map and its height reference. */
    @Override
    public String description() {
        String which =
                result.runs().size() > 1 ? ", in the first of " + result.runs().size() + " runs" : "";
        return "Where each sensor detects each drone" + which + ". " + heights() + " Fields of view are"
                + " drawn in plan, as if nothing obstructed them; that of a camera extends to the range at"
                + " which it first detects a drone, or to " + Math.round(MapFootprint.UNKNOWN_REACH)
                + " m if it detects none." + buildings();
    }

    /** The level from which the heights of buildings are measured, and the attribution that their map requires. */
    private String buildings() {
        return stage.buildings()
                .map(town -> " Heights of buildings are measured from the lowest ground below them; 'assumed' marks"
                        + " those that the map does not state."
                        + town.attribution()
                                .map(text -> " Buildings: " + text + ".")
                                .orElse(""))
                .orElse("");
    }

    private String heights() {
        return origin.height().isPresent()
                ? "Heights are metres above sea level."
                : "Heights are metres above the level of the scene's origin, neither above sea level nor above"
                        + " the ground:"
                        + " the altitude of the origin is unknown.";
    }

    /** Whether heights are those above the sea, so that features in the air can be drawn at their heights. */
    @Override
    public boolean isInSpace() {
        return origin.height().isPresent();
    }

    /** All features, in the order of their folders and of the scene. */
    @Override
    public List<StyledFeature> features() {
        List<StyledFeature> features = new ArrayList<>();
        // Below everything else.
        stage.buildings().stream()
                .flatMap(town -> town.outlines().stream())
                .map(outlines::feature)
                .forEach(features::add);
        settings.enabledSensors().forEach((id, sensor) -> features.add(sensor(id, sensor)));
        settings.enabledSensors().forEach((id, sensor) -> Outlined.outline(sensor)
                .map(outline -> MapFootprint.of(sensor.position(), outline, run.firstDetectionRange(id)))
                .ifPresent(rings -> features.add(field(id, sensor, rings))));
        settings.alert().protect().ifPresent(zone -> features.add(zone(zone)));
        stage.protection().areas().forEach(zone -> features.add(area(zone)));
        settings.individualDrones().forEach((id, drone) -> features.add(flight(id, drone)));
        run.alerts().forEach(result -> result.alert().ifPresent(alert -> features.add(alert(result.drone(), alert))));
        run.events().forEach(event -> features.add(event(event)));
        return features;
    }

    /** The folders of all roles that most scenes have, and those of the other roles that occur. */
    @Override
    public List<String> folders() {
        List<StyledFeature> features = features();
        return Arrays.stream(Role.values())
                .filter(role -> !role.isRare() || features.stream().anyMatch(feature -> feature.role() == role))
                .map(Role::folder)
                .distinct()
                .toList();
    }

    private Color colour(String sensor) {
        return colours.of(settings.sensors().get(sensor).kind());
    }

    private StyledFeature sensor(String id, SensorSettings<?> sensor) {
        Properties properties = new Properties()
                .put("kind", sensor.kind())
                .put("height_m", sensor.position().z());
        for (PairResult pair : run.pairs()) {
            if (pair.sensor().equals(id)) {
                properties
                        .put("first_detected_s_" + pair.drone(), pair.firstDetected())
                        .put("range_m_" + pair.drone(), pair.range());
            }
        }
        return new StyledFeature(Role.SENSOR, id, point(sensor.position()), colour(id), properties);
    }

    private StyledFeature field(String id, SensorSettings<?> sensor, List<List<Position>> rings) {
        Properties properties = new Properties().put("sensor", id).put("kind", sensor.kind());
        return new StyledFeature(Role.FIELD, "field of view of " + id, area(rings), colour(id), properties);
    }

    private StyledFeature zone(ProtectedZone zone) {
        Properties properties = new Properties()
                .put("radius_m", zone.radius())
                .put("height_m", zone.centre().z());
        Shape shape = zone.radius() > 0.0
                ? area(MapFootprint.of(zone.centre(), new Outline.Ball(zone.radius()), OptionalDouble.empty()))
                : point(zone.centre());
        return new StyledFeature(Role.ZONE, "protected", shape, ZONE, properties);
    }

    private StyledFeature area(AreaZone zone) {
        Properties properties = new Properties()
                .put("floor_above_ground_m", zone.settings().floor())
                .put("height_above_ground_m", zone.settings().height())
                .put("bottom_m", zone.bottom())
                .put("top_m", zone.top());
        zone.settings().radius().ifPresent(radius -> properties.put("radius_m", radius));
        double[] corners = zone.outline().stream()
                .flatMapToDouble(corner -> DoubleStream.of(corner.x(), corner.y()))
                .toArray();
        return new StyledFeature(
                Role.ZONE, zone.name(), outlines.area(corners, zone.settings().height()), ZONE, properties);
    }

    /** Where the drone was at its alert. */
    private StyledFeature alert(String drone, Alert alert) {
        Position position = stage.positionOf(drone, alert.time());
        Properties properties = new Properties()
                .put("drone", drone)
                .put("time_s", alert.time())
                .put("height_m", position.z())
                .put("sensors", String.join(", ", alert.sensors()));
        return new StyledFeature(Role.ALERT, "alert for " + drone, point(position), ZONE, properties);
    }

    /** The path of a drone or of a bird; a point for one that stays where it is. */
    private StyledFeature flight(String id, DroneSettings flying) {
        boolean isBird = flying.isBird();
        List<GeoPoint> positions = new ArrayList<>();
        for (int i = 0; i <= STEPS; i++) {
            GeoPoint position = geodesy.at(stage.positionOf(id, run.simulated() * i / STEPS));
            if (positions.isEmpty()
                    || !positions.get(positions.size() - 1).inSpace().equals(position.inSpace())) {
                positions.add(position);
            }
        }
        Shape shape = positions.size() > 1 ? new Shape.Line(positions) : new Shape.Point(positions.get(0));
        Properties properties =
                new Properties().put(isBird ? "bird" : "drone", id).put("duration_s", run.simulated());
        return new StyledFeature(
                isBird ? Role.BIRD : Role.FLIGHT,
                "flight of " + id + (isBird ? " (bird)" : ""),
                shape,
                KindColours.of(flying),
                properties);
    }

    /** The drone at the time of emission. */
    private StyledFeature event(DetectionEvent event) {
        Observation o = event.observation();
        Position position = stage.positionOf(o.drone(), o.time());
        Properties properties = new Properties()
                .put("event", event.gained() ? "gained" : "lost")
                .put("sensor", o.sensor())
                .put("kind", o.kind())
                .put("drone", o.drone())
                .put("time_s", o.time())
                .put("heard_s", o.arrival())
                .put("height_m", position.z())
                .put("range_m", o.range())
                .put("value", o.value())
                .put("threshold", o.threshold())
                .put("unit", o.unit());
        String name = o.sensor() + (event.gained() ? " detects " : " loses ") + o.drone();
        return new StyledFeature(
                event.gained() ? Role.GAINED : Role.LOST, name, point(position), colour(o.sensor()), properties);
    }

    private Shape area(List<List<Position>> rings) {
        return new Shape.Area(
                rings.stream()
                        .map(ring -> ring.stream().map(geodesy::at).toList())
                        .toList(),
                OptionalDouble.empty());
    }

    private Shape point(Position position) {
        return new Shape.Point(geodesy.at(position));
    }
}
