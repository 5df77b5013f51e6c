package org.dronewatch.app;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.scenario.SceneCondition;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;

/**
 * A scene under a condition.
 *
 * @param name of the condition
 * @param settings of the scene with its changes
 */
record ConditionedScene(String name, SceneSettings settings) {

    /**
     * A scene under each of some conditions; nothing is loaded.
     *
     * @param drone name of a drone that they must have
     * @throws InputException in one line with the location of a change that does not fit the scene
     */
    static List<ConditionedScene> of(List<SceneCondition> conditions, SceneChoice choice, String drone) {
        List<ConditionedScene> scenes = new ArrayList<>();
        for (SceneCondition condition : conditions) {
            SceneRunner runner = choice.runner(choice.create());
            SceneSettings settings = null;
            for (SceneCondition.Change change : condition.changes()) {
                try {
                    settings = runner.set(change.path(), change.value())
                            .settingsOfRuns()
                            .get(0);
                } catch (InputException e) {
                    String reason = e.getMessage().replaceFirst("^--set ", "");
                    throw new InputException(change.mark() + ": " + reason, e);
                }
                if (!settings.individualDrones().containsKey(drone)) {
                    throw new InputException(
                            change.mark() + ": " + change.path() + " leaves no drone '" + drone + "' in the scene");
                }
            }
            scenes.add(new ConditionedScene(condition.name(), settings));
        }
        return scenes;
    }
}
