package org.dronewatch.examples;

import java.nio.file.Path;
import java.util.List;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.route.SiteRoutes;
import org.dronewatch.route.proof.RouteProof;
import org.dronewatch.route.proof.RouteScene;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.run.Stage;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;

/** The weakest routes of a scene to what it protects, and how often a drone that flies one of them is detected. */
public final class RoutesOfAScene {
    private final SceneSettings settings;
    private final ModelCache models;
    private final Stage stage;
    private final String drone;

    /**
     * Loads a scene.
     *
     * @param runner a runner of the scene
     * @param settings settings of one of its runs
     * @param drone name of the drone that is to be detected
     */
    public RoutesOfAScene(SceneRunner runner, SceneSettings settings, String drone) {
        this.settings = settings;
        this.models = runner.load(settings);
        this.stage = runner.stage(settings);
        this.drone = drone;
    }

    /** Assesses the cells, searches for the routes past all sensors, and prints the weakest from each direction. */
    public SiteRoutes search(FieldGrid cells) {
        List<Course> courses = Course.all(settings.enabledSensors(), DetectionField.droneOf(stage, drone));
        DetectionField field = FieldAssessment.of(settings, stage, drone, cells, courses, cell -> {});
        SiteRoutes routes = SiteRoutes.of(field, settings, stage, drone);
        for (int sector = 0; sector < SiteRoutes.SECTORS; sector++) {
            routes.from(sector)
                    .ifPresent(route -> System.out.println(route.detection() + " " + routes.bySensor(route)));
        }
        return routes;
    }

    /** Flies a route a thousand times, and prints the predicted probability of a detection and the interval. */
    public RouteProof fly(SiteRoutes routes, WeakestRoute route) {
        SceneSettings scene =
                RouteScene.of(settings, drone, routes.flight(route).orElseThrow());
        RouteProof proof = RouteProof.of(scene, models, 1000, runs -> {});
        System.out.println(proof.predicted() + " " + proof.detection().interval() + " " + proof.agrees());
        return proof;
    }

    public static void main(String[] args) {
        SceneRunner runner = new SceneRunner(new SceneFile(Path.of("scenes/birds.yaml")));
        RoutesOfAScene birds = new RoutesOfAScene(runner, runner.settings(), "intruder");
        SiteRoutes routes = birds.search(new FieldGrid(0.0, 0.0, 1200.0, 40.0, List.of(10.0, 30.0, 60.0, 120.0)));
        routes.from(0).ifPresent(route -> birds.fly(routes, route));
    }
}
