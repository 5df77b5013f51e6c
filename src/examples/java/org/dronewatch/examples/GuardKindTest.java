package org.dronewatch.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.app.Program;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.Kind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class GuardKindTest {
    @TempDir
    private Path directory;

    /** Runs a scene file, and says where the guard first detects the intruder. */
    static final class RunFile {
        public static void main(String[] args) {
            SceneResult result = new SceneRunner(new SceneFile(Path.of(args[0]))).run();
            System.out.println(result.firstDetectionRange("eye", "intruder"));
        }
    }

    /**
     * In a separate process, whose class path names the kind as a jar would. A drone of 0.70 m subtends 0.2 degrees at
     * 202 m; the guard looks once a second, while the drone flies 20 m.
     */
    @Test
    void aSceneFileChoosesAGuard() throws IOException, InterruptedException {
        Path services = Files.createDirectories(directory.resolve("jar/META-INF/services"));
        Files.writeString(services.resolve(Kind.class.getName()), GuardKind.class.getName() + "\n");
        Files.writeString(directory.resolve("plain.obj"), "v -90 0 -90\nv 90 0 -90\nv 90 0 90\nf 1 3 2\n");
        Files.writeString(
                directory.resolve("guarded.yaml"),
                """
                world: {models: [plain.obj]}
                drones:
                  intruder:
                    model: packaged:quadrotor.obj
                    flight: {kind: approach, from: [0, 600, 20], to: [0, 0, 20]}
                    speed: 20 m/s
                sensors:
                  eye: {kind: guard, position: [0, 0, 20], rate: 60 /min, acuity: 0.2 deg}
                run: {duration: 29 s}
                """);
        List<Path> classPath = List.of(directory.resolve("jar"));
        List<String> options = List.of("-Xmx512m", "-XX:+UseSerialGC");
        try (Program.Child child = Program.startClass(RunFile.class, directory, classPath, options, "guarded.yaml")) {
            Program.Outcome outcome = child.await();
            assertThat(outcome.code()).as(outcome.err()).isZero();
            assertThat(outcome.out()).startsWith("OptionalDouble[200.0");
        }
    }
}
