package org.dronewatch.app.option;

import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Modifier;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Spelling;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/**
 * A scene given by its name, and the settings to change in it; subclasses define where on the command line the name is
 * given.
 */
public abstract class ChosenScene {
    static final String DESCRIPTION =
            "A packaged scene (see 'list'), a scene file in YAML, or a class that extends Scene.";

    @Option(
            names = "--set",
            paramLabel = "PATH=VALUE",
            description = "Overrides a setting by its path, with a unit or without: --set sensors.camera.fov='40 deg'.")
    private List<String> overrides = new ArrayList<>();

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    /** What a shell offers for the scene, besides files. */
    static final class PackagedNames implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return PackagedScene.all().stream().map(PackagedScene::name).iterator();
        }
    }

    /** The name of the scene. */
    abstract String name();

    /** A new instance of the scene, without the overrides. */
    public final Scene create() {
        return create(name());
    }

    /** A new scene by its name, as it is. */
    static Scene create(String name) {
        if (SceneFile.isFileName(name)) {
            return new SceneFile(file(name));
        }
        return PackagedScene.find(name).map(scene -> scene.factory().get()).orElseGet(() -> fromClass(name));
    }

    /** Whether a setting of the scene is to be changed. */
    final boolean hasOverrides() {
        return !overrides.isEmpty();
    }

    /** The file that describes the scene; empty when it is packaged or a class. */
    public final Optional<Path> sceneFile() {
        return SceneFile.isFileName(name()) ? Optional.of(file(name())) : Optional.empty();
    }

    /** Whether a path leads to the file that describes the scene, even under another name. */
    public final boolean isSceneFile(Path path) {
        try {
            Optional<Path> file = sceneFile();
            return file.isPresent() && Files.isSameFile(file.get(), path);
        } catch (IOException e) {
            // One of them does not exist; reading or writing will report that if it matters.
            return false;
        }
    }

    private static Path file(String name) {
        try {
            return Path.of(name);
        } catch (InvalidPathException e) {
            throw new InputException("scene file '" + name + "' is not a path: " + e.getReason(), e);
        }
    }

    /** A runner of a scene with the overrides. */
    public final SceneRunner runner(Scene scene) {
        SceneRunner runner = new SceneRunner(scene).store(StoreSwitch.of(command));
        for (String override : overrides) {
            int equals = override.indexOf('=');
            if (equals < 1) {
                throw new InputException("--set " + PlainText.value(override) + ": must be PATH=VALUE");
            }
            runner.set(
                    override.substring(0, equals).strip(),
                    override.substring(equals + 1).strip());
        }
        return runner;
    }

    private static Scene fromClass(String name) {
        Class<?> type;
        try {
            ClassLoader loader = Thread.currentThread().getContextClassLoader();
            type = Class.forName(name, false, loader);
        } catch (ClassNotFoundException e) {
            throw unknown(name, e);
        } catch (NoClassDefFoundError e) {
            // On a file system that ignores case, a class is found by a name that differs from its own.
            if (String.valueOf(e.getMessage()).contains("wrong name")) {
                throw unknown(name, e);
            }
            throw e;
        }
        if (!Scene.class.isAssignableFrom(type) || Modifier.isAbstract(type.getModifiers())) {
            throw new InputException("class " + name + " is not a scene: it must extend " + Scene.class.getName());
        }
        try {
            return (Scene) type.getConstructor().newInstance();
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof Error error) {
                throw error;
            }
            throw new InputException("scene " + name + " failed in its constructor: " + e.getCause(), e);
        } catch (ReflectiveOperationException e) {
            throw new InputException(
                    "scene " + name + " needs a public class and a public constructor without arguments", e);
        }
    }

    private static InputException unknown(String name, Throwable cause) {
        List<String> known =
                PackagedScene.all().stream().map(PackagedScene::name).toList();
        return new InputException(
                "unknown scene '" + PlainText.value(name) + "': neither packaged (" + String.join(", ", known)
                        + "), nor a .yaml file, nor a class on the class path" + Spelling.didYouMean(name, known),
                cause);
    }
}
