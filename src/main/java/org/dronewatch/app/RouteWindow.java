package org.dronewatch.app;

import java.util.Optional;
import org.dronewatch.report.route.RouteLines;
import org.dronewatch.report.route.RouteScenes;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.GivenScene;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.viewer.Viewer;

/** The window in which a drone flies each of the routes that were found, all at the same time. */
final class RouteWindow {
    private final Scene scene;
    private final SceneRunner runner;
    private final SceneWindow window;

    /**
     * A window that is not open yet.
     *
     * @param runner runner of the scene
     */
    RouteWindow(Scene scene, SceneRunner runner, SceneWindow window) {
        this.scene = scene;
        this.runner = runner;
        this.window = window;
    }

    /** Whether a window can be opened; if not, says why. */
    boolean canOpen() {
        return window.canOpen();
    }

    /** Opens it if there is a route, and returns when it is closed. */
    void show(RouteSurvey survey, RouteScenes scenes) {
        Optional<SceneSettings> together = scenes.together(survey);
        if (together.isPresent()) {
            Scene routes = new GivenScene(scene.name() + ": weakest routes", scene.directory(), together.get());
            SceneRunner flights = new SceneRunner(routes).store(runner.store()).share(runner.load(together.get()));
            window.show(
                    new Viewer.Subject(routes, flights, Optional.empty()),
                    viewer -> viewer.showLines(RouteLines.of(survey)));
        }
    }
}
