package org.dronewatch.app;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Modifier;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Which scene, and what to change in it: the part that several commands share. */
final class SceneChoice {
    @Parameters(
            index = "0",
            paramLabel = "SCENE",
            description = "A packaged scene (see 'list'), a scene file in YAML, or a class that extends Scene.")
    private String name;

    @Option(
            names = "--set",
            paramLabel = "PATH=VALUE",
            description = "Overrides a setting by its path, with a unit or without: --set sensors.camera.fov='40 deg'.")
    private List<String> overrides = new ArrayList<>();

    /** A new scene. */
    Scene create() {
        if (SceneFile.isFileName(name)) {
            return new SceneFile(file());
        }
        return PackagedScene.find(name).map(scene -> scene.factory().get()).orElseGet(this::fromClass);
    }

    private Path file() {
        try {
            return Path.of(name);
        } catch (InvalidPathException e) {
            throw new InputException("scene file '" + name + "' is no path: " + e.getReason(), e);
        }
    }

    /** A runner of a scene with the overrides. */
    SceneRunner runner(Scene scene) {
        SceneRunner runner = new SceneRunner(scene);
        for (String override : overrides) {
            int equals = override.indexOf('=');
            if (equals < 1) {
                throw new InputException("--set " + override + ": must be PATH=VALUE");
            }
            runner.set(
                    override.substring(0, equals).strip(),
                    override.substring(equals + 1).strip());
        }
        return runner;
    }

    private Scene fromClass() {
        Class<?> type;
        try {
            ClassLoader loader = Thread.currentThread().getContextClassLoader();
            type = Class.forName(name, false, loader);
        } catch (ClassNotFoundException | LinkageError e) {
            throw unknown(e);
        }
        if (!Scene.class.isAssignableFrom(type) || Modifier.isAbstract(type.getModifiers())) {
            throw new InputException("class " + name + " is no scene: it must extend " + Scene.class.getName());
        }
        try {
            return (Scene) type.getConstructor().newInstance();
        } catch (InvocationTargetException e) {
            throw new InputException("scene " + name + " failed in its constructor: " + e.getCause(), e);
        } catch (ReflectiveOperationException e) {
            throw new InputException(
                    "scene " + name + " needs a public class and a public constructor without arguments", e);
        }
    }

    private InputException unknown(Throwable cause) {
        String known = PackagedScene.all().stream().map(PackagedScene::name).collect(Collectors.joining(", "));
        return new InputException(
                "unknown scene '" + name + "': neither packaged (" + known
                        + "), nor a .yaml file, nor a class on the class path",
                cause);
    }
}
