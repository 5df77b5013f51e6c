package org.dronewatch.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.dronewatch.scenario.SceneCondition;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.InputException;

/**
 * A scene with some settings changed by a condition, such as rain or night.
 *
 * @param name name of the condition
 * @param settings settings of the scene with the changes of the condition
 */
public record ConditionedScene(String name, SceneSettings settings) {

    /**
     * A scene under each of several conditions; nothing is loaded.
     *
     * @param runners makes a new runner of the scene without any condition
     * @param drone name of a drone that each of these scenes must have
     * @throws InputException if a change does not fit the scene, in one line with the location of the change
     */
    public static List<ConditionedScene> of(
            List<SceneCondition> conditions, Supplier<SceneRunner> runners, String drone) {
        List<ConditionedScene> scenes = new ArrayList<>();
        for (SceneCondition condition : conditions) {
            SceneRunner runner = runners.get();
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
