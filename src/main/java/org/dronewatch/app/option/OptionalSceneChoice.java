package org.dronewatch.app.option;

import org.dronewatch.setting.InputException;
import picocli.CommandLine.Parameters;

/** The scene and the changes to it, for a command that lets the user choose a scene if none is named. */
public final class OptionalSceneChoice extends ChosenScene {
    @Parameters(
            index = "0",
            arity = "0..1",
            paramLabel = "SCENE",
            completionCandidates = PackagedNames.class,
            description = {DESCRIPTION, "Without one, a window shows the packaged scenes to choose from."})
    private String name;

    @Override
    String name() {
        return name;
    }

    /**
     * Whether a scene is named.
     *
     * @throws InputException if none is named although settings are to be changed
     */
    public boolean isNamed() {
        if (name == null && hasOverrides()) {
            throw new InputException("--set changes the settings of one scene: name the SCENE as well");
        }
        return name != null;
    }
}
