package org.dronewatch.app.option;

import java.util.List;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Parameters;

/** The scene and the changes to it, as several commands take them. */
public final class SceneChoice extends ChosenScene {
    @Parameters(
            index = "0",
            paramLabel = "SCENE",
            completionCandidates = PackagedNames.class,
            description = DESCRIPTION)
    private String name;

    @Override
    String name() {
        return name;
    }

    /** A new scene by its name, without overrides. */
    public static Scene named(String name) {
        return create(name);
    }

    /**
     * The settings of one run of a sweep, or of the only run of a scene without a sweep.
     *
     * @param run the value of {@code --run}
     * @throws InputException when there is no such run
     */
    public static SceneSettings settingsOfRun(SceneRunner runner, int run) {
        List<SceneSettings> runs = runner.settingsOfRuns();
        if (run < 0 || run >= runs.size()) {
            throw new InputException("--run " + run + ": must be "
                    + (runs.size() == 1 ? "0, because no setting is swept" : "0 to " + (runs.size() - 1)));
        }
        return runs.get(run);
    }
}
