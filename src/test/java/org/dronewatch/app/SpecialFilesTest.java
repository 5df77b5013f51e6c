package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assumptions.abort;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Pipes, devices and files without end where a small file is expected: a line, at once, and in little memory. */
class SpecialFilesTest {
    private static final Path ENDLESS = Path.of("/dev/zero");

    @TempDir
    private Path directory;

    @BeforeEach
    void model() throws IOException {
        Files.copy(Program.FUZZ.resolve("square.obj"), directory.resolve("square.obj"));
    }

    private Path fifo(String name) throws IOException, InterruptedException {
        Path fifo = directory.resolve(name);
        Process made;
        try {
            made = new ProcessBuilder("mkfifo", fifo.toString()).start();
        } catch (IOException e) {
            assumeTrue(false, "there are no pipes in the file system here");
            throw e;
        }
        assumeTrue(made.waitFor() == 0, "there are no pipes in the file system here");
        return fifo;
    }

    private Path endless(String name) throws IOException {
        assumeTrue(Files.exists(ENDLESS));
        try {
            return Files.createSymbolicLink(directory.resolve(name), ENDLESS);
        } catch (UnsupportedOperationException | FileSystemException e) {
            return abort("there are no symbolic links here: " + e.getMessage());
        }
    }

    /** A file without a line break: zeros, which take no room on the disk. */
    private void oneLine(String name, int bytes) throws IOException {
        try (RandomAccessFile file =
                new RandomAccessFile(directory.resolve(name).toFile(), "rw")) {
            file.setLength(bytes);
        }
    }

    private void assertRefused(String what, String... command) {
        Outcome outcome = assertTimeoutPreemptively(Duration.ofMinutes(1), () -> Program.run(command));
        assertThat(outcome.code()).as(outcome.err()).isEqualTo(2);
        assertThat(outcome.complaints()).hasSize(1);
        assertThat(outcome.complaints().get(0)).contains(what);
    }

    @Test
    void aSceneFileIsAFile() throws IOException, InterruptedException {
        assertRefused("is a pipe or a device", "check", fifo("pipe.yaml").toString());
        assertRefused("is a pipe or a device", "run", endless("zero.yaml").toString());
        Path folder = Files.createDirectory(directory.resolve("folder.yaml"));
        assertRefused("is a directory", "check", folder.toString());
        assertRefused("no such file", "check", directory.resolve("none.yaml").toString());
        oneLine("large.yaml", 150 << 20);
        assertRefused(
                "larger than 1048576 bytes",
                "check",
                directory.resolve("large.yaml").toString());
    }

    @Test
    void whatIsUsedIsAFileAndIsAskedForNothingElse() throws IOException, InterruptedException {
        Path scene = directory.resolve("site.yaml");
        Files.writeString(
                scene, "world: {models: [square.obj]}\nsensors: {eye: {use: roof-camra, position: [0, 0, 2]}}\n");
        Files.writeString(directory.resolve("roof-camera.yaml"), "title: mine\nsensor:\n  kind: camera\n");
        fifo("pipe.yaml");
        endless("zero.yaml");
        oneLine("large.yaml", 150 << 20);
        Files.createDirectory(directory.resolve("folder.yaml"));
        assertRefused("did you mean 'roof-camera'", "check", scene.toString());

        for (String name : new String[] {"pipe", "zero", "folder"}) {
            Files.writeString(
                    scene, "world: {models: [square.obj]}\nsensors: {eye: {use: " + name + ", position: [0, 0, 2]}}\n");
            assertRefused(name + ".yaml: cannot be read: is a ", "check", scene.toString());
        }
        Files.writeString(scene, "world: {models: [square.obj]}\nsensors: {eye: {use: large, position: [0, 0, 2]}}\n");
        assertRefused("larger than 1048576 bytes", "check", scene.toString());
        assertRefused("pipe", "check", "camera-range", "--set", "sensors.camera=pipe", "--set", "run.duration=1");
    }

    @Test
    void aRayFileIsAFile() throws IOException, InterruptedException {
        String model = directory.resolve("square.obj").toString();
        assertRefused(
                "a pipe or a device", "bench", model, "--rays", fifo("pipe").toString());
        assertRefused(
                "a pipe or a device", "bench", model, "--rays", endless("zero").toString());
        assertRefused("is a directory", "bench", model, "--rays", directory.toString());
        assertRefused(
                "no such file",
                "bench",
                model,
                "--rays",
                directory.resolve("none").toString());
    }

    @Test
    void aModelIsAFile() throws IOException, InterruptedException {
        assertRefused(
                "is a pipe or a device, not a file", "bench", fifo("pipe.obj").toString());
        assertRefused(
                "is a pipe or a device, not a file",
                "bench",
                endless("zero.obj").toString());
    }
}
