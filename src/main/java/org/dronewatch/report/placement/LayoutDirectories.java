package org.dronewatch.report.placement;

import java.nio.file.Path;
import java.util.Optional;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.report.provenance.ResultKind;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;

/** The directories in which a layout can be written as a scene: a scene names only files beside it or below it. */
final class LayoutDirectories {
    private LayoutDirectories() {}

    /**
     * The nearest of them, from the directory of the plan's scene upwards, that has no results of another command;
     * empty if there is none.
     *
     * @param layout the scene that is to be written
     * @param file its file name
     */
    static Optional<Path> nearest(PlacePlan plan, SceneSettings layout, String file) {
        Path directory = plan.scene().directory().toAbsolutePath().normalize();
        while (directory != null) {
            if (takes(plan, layout, directory, file)) {
                return Optional.of(directory);
            }
            directory = directory.getParent();
        }
        return Optional.empty();
    }

    private static boolean takes(PlacePlan plan, SceneSettings layout, Path directory, String file) {
        try {
            ResultKind.PLACE.checkAlone(directory);
            plan.runner().text(layout, directory.resolve(file));
            return true;
        } catch (InputException e) {
            return false;
        }
    }
}
