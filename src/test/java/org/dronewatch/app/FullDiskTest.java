package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Real disks of a few kilobytes: each command reports in one line that its disk is full, and leaves it as it was. */
class FullDiskTest {
    @TempDir
    private Path directory;

    private Path disk;

    private Map<String, String> files() throws IOException {
        Map<String, String> files = new TreeMap<>();
        try (Stream<Path> all = Files.walk(disk)) {
            for (Path file : all.toList()) {
                files.put(disk.relativize(file).toString(), Files.isDirectory(file) ? "" : Files.readString(file));
            }
        }
        return files;
    }

    /** The larger ones fail late: in the tables, in a plot, in the report. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "8k   | run camera-range --set run.duration=1 --out DISK/new",
                "12k  | run camera-range --observations --set run.duration=20 --out DISK/new",
                "12k  | run camera-range --observations --set run.duration=20 --out DISK/old",
                "12k  | run camera-range --set run.duration=1 --out DISK",
                "60k  | run camera-range --set sensors.camera.fov=60deg --set run.duration=1 --out DISK/old",
                "160k | run camera-range --set sensors.camera.fov=60deg --set run.duration=1 --out DISK/old",
                "12k  | run closed-space --set run.duration=0.1 --out OTHER --rays DISK/rays.obj",
                "12k  | render camera-range --camera camera --time 30 --out DISK/camera.png",
                "12k  | render camera-range --camera camera --time 30 --out DISK/camera.pfm",
                "12k  | render camera-range --view top --size 320x200 --out DISK/site.png",
                "12k  | coverage camera-range --cells 10 --out DISK/plan.png",
                "12k  | models --out DISK",
                "12k  | bench packaged:quadrotor.obj --passes 1 --rays RAYS --hits DISK/hits",
            })
    void aFullDiskIsOneLineAndStaysAsItWas(String size, String command) throws IOException, InterruptedException {
        try (SmallDisk small = new SmallDisk(directory.resolve("disk"), size)) {
            disk = small.path();
            assertThatItStaysAsItWas(command, small.reasonOfAFullDisk());
        }
    }

    private void assertThatItStaysAsItWas(String command, String reason) throws IOException {
        Files.createDirectories(disk.resolve("old"));
        Files.writeString(disk.resolve("old/summary.json"), "of an older run");
        Files.writeString(disk.resolve("camera.png"), "older");
        Map<String, String> before = files();
        Path rays = directory.resolve("many.rays");
        byte[] bytes = new byte[4 + 24 * 4000];
        bytes[0] = (byte) (4000 & 0xff);
        bytes[1] = (byte) (4000 >> 8);
        for (int i = 0; i < 4000; i++) {
            // A direction of (0, 0, 1), little endian.
            bytes[4 + 24 * i + 22] = (byte) 0x80;
            bytes[4 + 24 * i + 23] = (byte) 0x3f;
        }
        Files.write(rays, bytes);

        Outcome outcome = Program.run(command.replace("DISK", disk.toString())
                .replace("OTHER", directory.resolve("other").toString())
                .replace("RAYS", rays.toString())
                .split(" "));
        assertThat(outcome.code()).as(outcome.err()).isEqualTo(2);
        assertThat(outcome.complaints().stream().filter(line -> !line.startsWith("KDTreeStats")))
                .hasSize(1)
                .allSatisfy(
                        line -> assertThat(line).contains(disk.toString()).endsWith("cannot be written: " + reason));
        assertThat(files()).isEqualTo(before);
        assertThat(directory.resolve("other")).doesNotExist();
    }
}
