package org.dronewatch.route;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.RadarSignature;
import org.dronewatch.flight.RouteFlight;
import org.dronewatch.flight.RouteLeg;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.fusion.ProtectedZone;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.proof.FlownRoute;
import org.dronewatch.route.proof.RepeatedSearch;
import org.dronewatch.route.proof.RouteScene;
import org.dronewatch.run.Stage;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.camera.TargetTask;
import org.dronewatch.sensor.radar.RadarDetection;
import org.dronewatch.sensor.radar.RadarSettings;
import org.dronewatch.sensor.thermal.ThermalSettings;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.world.SiteMemory;

/** A real scene whose sensors leave detections to chance, and flights through it: weakest routes and random ones. */
final class PackagedFlights {
    /** Among cross-sections from 1e-8 to 10 m2. */
    private static final int BISECTIONS = 7;

    /** The response to an alert as a fraction of a random flight. */
    private static final double RESPONSE = 0.3;

    private static final List<Double> HEIGHTS = List.of(2.0, 10.0, 30.0, 60.0, 120.0, 300.0);

    private final String drone;
    private final SceneSettings settings;
    private final ModelCache models;
    private final Stage stage;
    /** By mode of flight, in their order. */
    private final List<ModeField> fields;

    private final DetectionField field;

    /** Loads a scene and assesses its field, on the workers of the calling thread. */
    PackagedFlights(FlownSite site) {
        Scene scene = site.scene().endsWith(".yaml")
                ? new SceneFile(Path.of(site.scene()))
                : PackagedScene.find(site.scene()).orElseThrow().factory().get();
        SceneRunner runner = new SceneRunner(scene).notes(note -> {});
        site.overrides().forEach(runner::set);
        this.drone = site.drone();
        this.settings = byChance(withEcho(runner.settingsOfRuns().get(0), drone, site.crossSection()));
        this.stage = runner.stage(settings);
        this.models = runner.load(settings);
        models.share(new SiteMemory(Runtime.getRuntime().maxMemory() / 8));
        Position middle = InboundTarget.of(settings, stage.protection());
        FieldGrid grid = new FieldGrid(middle.x(), middle.y(), site.side(), site.cell(), HEIGHTS);
        Drone flown = DetectionField.droneOf(stage, drone);
        this.fields = FlightMode.of(flown.settings(), settings.enabledSensors().values()).stream()
                .map(mode -> mode.with(
                        FieldAssessment.of(
                                settings,
                                stage,
                                drone,
                                grid,
                                mode.courses(settings.enabledSensors(), flown),
                                cells -> {}),
                        flown.settings()))
                .toList();
        this.field = fields.get(0).field();
    }

    ModelCache models() {
        return models;
    }

    /** Radars whose echoes fluctuate, and observers of cameras: most scenes leave nothing to chance. */
    private static SceneSettings byChance(SceneSettings scene) {
        SceneSettings changed = scene;
        for (Map.Entry<String, SensorSettings<?>> sensor : scene.sensors().entrySet()) {
            SensorSettings<?> other = sensor.getValue();
            if (other instanceof RadarSettings radar) {
                other = radar.withDetection(RadarDetection.Chance.DEFAULT);
            } else if (other instanceof CameraSettings camera && camera.detection() instanceof TargetTask task) {
                other = SettingsForm.with(camera, "detection", SettingsForm.with(task, "byChance", true));
            } else if (other instanceof ThermalSettings thermal) {
                other = SettingsForm.with(thermal, "byChance", true);
            }
            changed = changed.withSensor(sensor.getKey(), other);
        }
        return changed;
    }

    /**
     * Scenes in which the drone flies the weakest routes from up to so many directions, as {@code route} finds them: in
     * all modes of the drone, joined to others, and searched for again past what their looks show.
     */
    List<SceneSettings> weakest(int directions) {
        SiteRoutes routes = SiteRoutes.of(fields, settings, stage, drone, Optional.empty());
        RouteSurvey survey = RouteSurvey.of(routes, settings.alert().response(), sector -> {}, () -> {});
        RepeatedSearch search = new RepeatedSearch(routes, survey, route -> scene(routes, route)
                .map(scene -> route.with(FlownRoute.of(scene, models, 1).exposure()))
                .orElse(route));
        search.assess(route -> {});
        search.avoidLateDetections(done -> {});
        search.repeat(repetition -> {});
        search.avoidLateDetections(done -> {});
        return search.survey().routes().stream()
                .limit(directions)
                .flatMap(route -> scene(routes, route).stream())
                .toList();
    }

    private Optional<SceneSettings> scene(SiteRoutes routes, SectorRoute route) {
        return routes.flight(route.route()).map(flight -> RouteScene.of(settings, drone, flight));
    }

    /**
     * A scene in which the drone flies over three places between the cells of the field, with a cross-section at which
     * the radars alone may or may not detect it, if there is one.
     *
     * @param areAlone whether the other sensors, which are often certain to detect it, are then off
     */
    SceneSettings random(SplittableRandom random, boolean areAlone) {
        double usual = settings.individualDrones().get(drone).speed();
        List<RouteLeg> legs = new ArrayList<>();
        for (int leg = 0; leg < 2; leg++) {
            double speed = usual * (0.5 + random.nextDouble());
            legs.add(new RouteLeg(anywhere(random), Optional.of(speed), true));
        }
        SceneSettings flight = RouteScene.of(settings, drone, RouteFlight.of(anywhere(random), legs));
        AlertSettings alert = flight.alert()
                .withProtectedZone(
                        new ProtectedZone(legs.get(1).to(), 1.0),
                        RESPONSE * flight.run().duration());
        return leftToChance(SettingsForm.with(flight, "alert", alert), areAlone);
    }

    private SceneSettings leftToChance(SceneSettings scene, boolean areAlone) {
        SceneSettings radars = scene;
        for (String sensor : scene.enabledSensors().keySet()) {
            radars = radars.withEnabled(sensor, scene.sensors().get(sensor) instanceof RadarSettings);
        }
        double low = -8.0;
        double high = 1.0;
        for (int i = 0; !radars.enabledSensors().isEmpty() && i < BISECTIONS; i++) {
            double middle = 0.5 * (low + high);
            double detected = FlownRoute.of(withEcho(radars, drone, Math.pow(10.0, middle)), models)
                    .detection();
            if (detected > 0.05 && detected < 0.95) {
                return withEcho(areAlone ? radars : scene, drone, Math.pow(10.0, middle));
            }
            low = detected <= 0.05 ? middle : low;
            high = detected >= 0.95 ? middle : high;
        }
        return scene;
    }

    private static SceneSettings withEcho(SceneSettings scene, String drone, double area) {
        RadarSignature echo = RadarSignature.DEFAULT.withCrossSection(area);
        DroneSettings other = scene.individualDrones().get(drone).withRadar(echo);
        return scene.withDrone(drone, other);
    }

    /** In an open cell, but not in its middle. */
    private Position anywhere(SplittableRandom random) {
        while (true) {
            int height = random.nextInt(field.grid().heights().size());
            int column = random.nextInt(field.grid().columns());
            int row = random.nextInt(field.grid().columns());
            if (field.isOpen(height, column, row)) {
                return field.middle(height, column, row)
                        .plus(new Position(random.nextDouble(), random.nextDouble(), random.nextDouble()));
            }
        }
    }
}
