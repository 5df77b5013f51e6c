package org.dronewatch.report.placement;

import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.report.provenance.SceneDirectories;
import org.dronewatch.scenario.PriceSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.OutsideFileException;
import org.dronewatch.setting.SettingsForm;

/** The warning that a layout is not written as a scene, which is given only once. */
final class LayoutWarning {
    private final PlacePlan plan;
    private final Path file;
    private final SceneDirectories directories;
    private boolean isGiven;

    /**
     * No warning so far.
     *
     * @param file the scene that is to be written
     * @param directories where else it can be written
     */
    LayoutWarning(PlacePlan plan, Path file, SceneDirectories directories) {
        this.plan = plan;
        this.file = file;
        this.directories = directories;
    }

    /** Warns if the layout cannot be written, whatever its sensors are. */
    void foresee(Consumer<String> notes) {
        // Sensors name no files. The alert and the prices, which refer to sensors, do not either.
        SceneSettings bare = SettingsForm.with(
                plan.present(),
                Map.of(
                        "sensors",
                        Map.of(),
                        "disabled",
                        Set.of(),
                        "alert",
                        AlertSettings.DEFAULT,
                        "prices",
                        PriceSettings.DEFAULT));
        try {
            plan.runner().text(bare, file);
        } catch (InputException e) {
            give(bare, e, notes);
        }
    }

    /** States why a scene is not written, and in which directory it can be. */
    void give(SceneSettings scene, InputException cause, Consumer<String> notes) {
        if (cause instanceof OutsideFileException outside) {
            give(
                    outside.fact() + "; "
                            + directories.advice(
                                    directory -> plan.runner().text(scene, directory.resolve(file.getFileName()))),
                    notes);
        } else {
            give(cause.getMessage(), notes);
        }
    }

    /** States why a scene is not written. */
    void give(String reason, Consumer<String> notes) {
        if (!isGiven) {
            notes.accept("warning: the layout is not written as a scene, so there is no " + file.getFileName() + ": "
                    + reason);
            isGiven = true;
        }
    }
}
