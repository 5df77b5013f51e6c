package org.dronewatch.report.placement;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.site.Layout;
import org.dronewatch.report.file.JsonFile;
import org.dronewatch.report.file.OutputDirectory;
import org.dronewatch.report.file.ShellWord;
import org.dronewatch.report.html.Figure;
import org.dronewatch.report.provenance.CommandInputs;
import org.dronewatch.report.provenance.Provenance;
import org.dronewatch.report.provenance.ProvenanceFile;
import org.dronewatch.report.provenance.ResultKind;
import org.dronewatch.report.provenance.SceneDirectories;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;

/** The directory into which {@code place} writes; its files appear together or not at all. */
public final class PlaceDirectory implements AutoCloseable {
    private static final String NUMBERS = ResultKind.PLACE.sign();
    private static final String SCENE = "layout.yaml";

    /**
     * All other files that a placement may write: those of an earlier one, such as the scene of another layout, are
     * removed unless they are replaced.
     */
    private static final Pattern FILES =
            Pattern.compile("layout\\.yaml|report\\.html|front\\.png|(layout|today|change)-[0-9.]+\\.png"
                    + "|(routes|warnings)(-today)?\\.png");

    private final Path target;
    private final OutputDirectory directory;
    private final LayoutWarning warning;

    /**
     * Makes sure that the directory can be written, before the work begins.
     *
     * @param placement placement file
     * @param plan the plan in that file
     * @throws InputException when it cannot be written, holds the results of another command, or holds an input of the
     *     search that would be replaced
     */
    public PlaceDirectory(Path target, Path placement, PlacePlan plan) {
        ResultKind.PLACE.checkAlone(target);
        CommandInputs inputs = inputs(placement, plan);
        inputs.checkKept(target, FILES);
        this.target = target;
        this.warning = new LayoutWarning(
                plan,
                target.resolve(SCENE),
                new SceneDirectories(plan.scene().directory(), ResultKind.PLACE, FILES, inputs));
        this.directory = new OutputDirectory(target);
    }

    /** The placement file and the files of its plan. */
    private static CommandInputs inputs(Path placement, PlacePlan plan) {
        List<Path> files = new ArrayList<>(List.of(placement));
        plan.conditionsFile().ifPresent(files::add);
        files.addAll(CommandInputs.of(plan.scene()).files());
        return new CommandInputs(files);
    }

    /**
     * Writes all files, on the {@link org.dronewatch.parallel.Workers} of the calling thread.
     *
     * @param provenance origin of the results
     * @param threads number of worker threads
     * @param notes receives a line on what could not be written
     * @return the file in which the layout is written as a scene, as a command-line argument, quoted if necessary;
     *     empty if no scene is written
     * @throws InputException when writing fails
     */
    public Optional<String> write(PlaceResults results, Provenance provenance, int threads, Consumer<String> notes) {
        PlacePlan plan = results.best().plan();
        directory.write(() -> {
            Optional<SceneSettings> layout = writeCommon(results, provenance, threads, notes);
            writeReport(results, layout, provenance.inWords(plan.present().run().seed(), threads));
            directory.publish(directory.former(NUMBERS, FILES));
        });
        return Files.exists(target.resolve(SCENE)) ? Optional.of(scene()) : Optional.empty();
    }

    private String scene() {
        return ShellWord.of(target.resolve(SCENE));
    }

    /**
     * Writes the numbers, their provenance, and the layout as a scene; returns the settings of that scene if they are
     * consistent.
     */
    private Optional<SceneSettings> writeCommon(
            PlaceResults results, Provenance provenance, int threads, Consumer<String> notes) throws IOException {
        PlacePlan plan = results.best().plan();
        JsonFile.write(directory.file(NUMBERS), results.toJson());
        JsonFile.write(
                directory.file(ProvenanceFile.NAME),
                ProvenanceFile.of(provenance, plan.scene().name(), threads));
        try {
            SceneSettings layout = Layout.of(plan, results.best().chosen());
            writeScene(plan, layout, notes);
            return Optional.of(layout);
        } catch (InputException e) {
            warning.give(e.getMessage(), notes);
            return Optional.empty();
        }
    }

    private void writeScene(PlacePlan plan, SceneSettings layout, Consumer<String> notes) throws IOException {
        try {
            String text = plan.runner().text(layout, target.resolve(SCENE));
            Files.write(directory.file(SCENE), text.getBytes(StandardCharsets.UTF_8));
        } catch (InputException e) {
            warning.give(layout, e, notes);
        }
    }

    /**
     * Warns if no layout, whatever its sensors, can be written as a scene. To be called before the search, which may
     * take long.
     *
     * @param notes receives the warning, in one line
     */
    public void foresee(Consumer<String> notes) {
        warning.foresee(notes);
    }

    private void writeReport(PlaceResults results, Optional<SceneSettings> layout, Map<String, String> provenance)
            throws IOException {
        PlacePlan plan = results.best().plan();
        Stage stage = plan.runner().stage(plan.present());
        PlaceReport report = new PlaceReport(results, stage);
        Map<String, Figure> pictures = report.pictures();
        for (Map.Entry<String, Figure> picture : pictures.entrySet()) {
            Files.write(directory.file(picture.getKey()), picture.getValue().png());
        }
        try (OutputStream page = Files.newOutputStream(directory.file("report.html"))) {
            report.write(
                    page,
                    pictures,
                    layout.orElseGet(() -> Layout.alone(plan, results.best().chosen())),
                    Files.exists(directory.file(SCENE)) ? results.reproduction(scene()) : List.of(),
                    provenance);
        }
    }

    /** Removes what was not written completely. */
    @Override
    public void close() {
        directory.close();
    }
}
