package org.dronewatch.report.route;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import org.dronewatch.render.Fineness;
import org.dronewatch.render.Orbit;
import org.dronewatch.render.SitePicture;
import org.dronewatch.render.SiteState;
import org.dronewatch.render.SiteStyle;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.run.Stage;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;

/** The site in perspective with the routes over it, coloured by how exposed the drone is on them. */
final class RouteView {
    private static final int WIDTH = 1200;
    private static final int HEIGHT = 720;

    private RouteView() {}

    /**
     * The picture, on the {@link org.dronewatch.parallel.Workers} of the calling thread.
     *
     * @param models models of the scene
     * @return empty if there is no route
     */
    static Optional<BufferedImage> of(RouteSurvey survey, RouteInputs inputs, RouteScenes scenes, ModelCache models) {
        return scenes.together(survey)
                .map(scene -> draw(
                        survey,
                        inputs,
                        scene,
                        new Stage(scene, models, scene.run().seed())));
    }

    private static BufferedImage draw(RouteSurvey survey, RouteInputs inputs, SceneSettings scene, Stage stage) {
        SitePicture picture = new SitePicture(scene, stage);
        SiteState state = picture.state(
                inputs.scene(),
                0.0,
                (sensor, drone) -> false,
                sensor -> Optional.empty(),
                Optional.empty(),
                Optional.empty());
        SiteState bare = new SiteState(
                state.title(), state.time(), state.sensors(), List.of(), Optional.empty(), Optional.empty());
        Orbit orbit = Orbit.about(picture.interest(), (double) WIDTH / HEIGHT);
        return picture.draw(
                picture.backdrop(orbit, WIDTH, HEIGHT, picture.openRoof(0.0), Fineness.FINE, () -> false),
                bare,
                SiteStyle.DEFAULT.withLines(RouteLines.of(survey)));
    }
}
