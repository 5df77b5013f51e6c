package org.dronewatch.scenes;

import java.nio.file.Path;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Spelling;
import org.dronewatch.setting.input.LinkOut;

/** Finds the scene that a file names. */
public final class SceneByName {
    private SceneByName() {}

    /**
     * A packaged scene, or a scene file in or below the directory of the file that names it. A class cannot be named,
     * since no code is loaded from data.
     *
     * @param directory directory of the naming file
     * @param name name of a packaged scene, or path of a scene file relative to the directory
     * @param file what the naming file is, for messages, such as {@code campaign file}
     * @throws InputException with a one-line message when there is no such scene, or its file is not in or below that
     *     directory
     */
    public static Scene of(Path directory, String name, String file) {
        if (SceneFile.isFileName(name)) {
            Path path = directory.resolve(name).normalize();
            if (!path.startsWith(directory.normalize())) {
                throw new InputException("scene '" + PlainText.value(name) + "': a scene file must lie in the "
                        + "directory of the " + file + " or below it");
            }
            LinkOut.refuse(directory, path, "scene");
            return new SceneFile(path);
        }
        return PackagedScene.find(name).map(scene -> scene.factory().get()).orElseThrow(() -> {
            var known = PackagedScene.all().stream().map(PackagedScene::name).toList();
            return new InputException("scene '" + PlainText.value(name) + "': neither packaged ("
                    + String.join(", ", known) + ") nor a .yaml file" + Spelling.didYouMean(name, known));
        });
    }
}
