package org.dronewatch.app.option;

import java.util.Optional;
import org.dronewatch.scene.Scene;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Option;

/** The option that names a second scene, with which the first is compared in the window. */
public final class BesideOption {
    @Option(
            names = "--beside",
            paramLabel = "OTHER",
            completionCandidates = ChosenScene.PackagedNames.class,
            description = {
                "Another scene, or the same one: its first run is shown beside that of SCENE, and a table lists"
                        + " the differences. --set changes SCENE only."
            })
    private String name;

    /**
     * The second scene, without the overrides of the first; empty if none is named.
     *
     * @param first the first scene
     * @throws InputException with a one-line message when there is no such scene, or no first scene is named
     */
    public Optional<Scene> scene(OptionalSceneChoice first) {
        if (name != null && !first.isNamed()) {
            throw new InputException("--beside compares with a scene: name the SCENE as well");
        }
        return Optional.ofNullable(name).map(ChosenScene::create);
    }
}
