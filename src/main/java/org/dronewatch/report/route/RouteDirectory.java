package org.dronewatch.report.route;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import org.dronewatch.report.Charts;
import org.dronewatch.report.file.JsonFile;
import org.dronewatch.report.file.OutputDirectory;
import org.dronewatch.report.html.Figure;
import org.dronewatch.report.map.RouteMap;
import org.dronewatch.report.provenance.CommandInputs;
import org.dronewatch.report.provenance.Provenance;
import org.dronewatch.report.provenance.ProvenanceFile;
import org.dronewatch.report.provenance.ResultKind;
import org.dronewatch.report.provenance.SceneDirectories;
import org.dronewatch.report.sheet.MapSheet;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.run.Stage;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scene.Scene;
import org.dronewatch.setting.InputException;

/** The directory into which {@code route} writes; its files appear together or not at all. */
public final class RouteDirectory implements AutoCloseable {
    private static final String NUMBERS = ResultKind.ROUTE.sign();

    /** All other files that a search may write: those of an earlier one are removed unless they are replaced. */
    private static final Pattern FILES = Pattern.compile(
            "route-(north|south)?-?(east|west)?\\.yaml|(routes|profile|time-to-go|view)\\.png|routes\\.(geojson|kml)|report\\.html");

    private final Path target;
    private final SceneDirectories directories;
    private final OutputDirectory directory;

    /**
     * Makes sure that the directory can be written, before the work begins.
     *
     * @throws InputException when it cannot be written, holds the results of another command, or holds the scene itself
     *     under the name of a result
     */
    public RouteDirectory(Path target, Scene scene) {
        ResultKind.ROUTE.checkAlone(target);
        CommandInputs inputs = CommandInputs.of(scene);
        inputs.checkKept(target, FILES);
        this.target = target;
        this.directories = new SceneDirectories(scene.directory(), ResultKind.ROUTE, FILES, inputs);
        this.directory = new OutputDirectory(target);
    }

    /**
     * Writes all files, on the {@link org.dronewatch.parallel.Workers} of the calling thread.
     *
     * @param stage the site
     * @param models cache of the scene's models
     * @param provenance the origin of the results
     * @param threads number of worker threads
     * @param notes receives a line on what could not be written
     * @throws InputException when writing fails
     */
    public void write(
            RouteResults results,
            RouteInputs inputs,
            RouteScenes scenes,
            Stage stage,
            ModelCache models,
            Provenance provenance,
            int threads,
            Consumer<String> notes) {
        directory.write(() -> {
            JsonFile.write(directory.file(NUMBERS), RouteFile.toJson(results, inputs));
            JsonFile.write(directory.file(ProvenanceFile.NAME), ProvenanceFile.of(provenance, inputs.scene(), threads));
            if (inputs.origin().isPresent()) {
                RouteMap map = new RouteMap(inputs.scene(), inputs.origin().get(), RoutePieces.of(results.survey()));
                map.writeGeoJson(directory.file("routes.geojson"));
                map.writeKml(directory.file("routes.kml"));
            } else {
                notes.accept("the scene has no world.origin: no GeoJSON or KML files are written");
            }
            scenes.write(results.survey(), target, directories, directory).ifPresent(notes);
            Map<String, Figure> figures = figures(results, inputs, scenes, stage, models);
            for (Map.Entry<String, Figure> figure : figures.entrySet()) {
                Files.write(directory.file(figure.getKey()), figure.getValue().png());
            }
            try (OutputStream page = Files.newOutputStream(directory.file("report.html"))) {
                new RouteReport(results, inputs, stage)
                        .write(
                                page,
                                figures.values(),
                                provenance.inWords(inputs.settings().run().seed(), threads));
            }
            directory.publish(directory.former(NUMBERS, FILES));
        });
    }

    /** The pictures by the names of their files, in the order of the report. */
    private static Map<String, Figure> figures(
            RouteResults results, RouteInputs inputs, RouteScenes scenes, Stage stage, ModelCache models)
            throws IOException {
        RouteSurvey survey = results.survey();
        int[] ground = MapSheet.ground(stage.world(), inputs.grid());
        Map<String, Figure> figures = new LinkedHashMap<>();
        figures.put(
                "routes.png",
                new RoutePictures(stage, inputs).plan(survey, ground).figure());
        figures.put(
                "time-to-go.png",
                new TimeToGoPicture(stage, inputs, results.times())
                        .sheet(ground)
                        .figure());
        Optional<BufferedImage> view = RouteView.of(survey, inputs, scenes, models);
        if (view.isPresent()) {
            figures.put("view.png", Figure.of("The routes from the side, coloured as on the map.", view.get()));
        }
        Optional<SectorRoute> weakest = survey.weakest();
        if (weakest.isPresent()) {
            BufferedImage profile = Charts.picture(RouteProfilePicture.of(weakest.get(), inputs));
            String caption =
                    "The weakest route: its height above the ground, and the probability that the drone has already"
                            + " been detected.";
            figures.put("profile.png", Figure.of(caption, profile));
        }
        return figures;
    }

    /** Removes what was not written completely. */
    @Override
    public void close() {
        directory.close();
    }
}
