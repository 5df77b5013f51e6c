package org.dronewatch.app;

import static org.junit.jupiter.api.Assumptions.abort;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;

/** A real disk of a few kilobytes; tests that need one are left out where it cannot be mounted. */
final class SmallDisk implements AutoCloseable {
    private final Path path;

    /**
     * Mounts a disk.
     *
     * @param path of a new directory
     * @param size such as {@code 12k}
     */
    SmallDisk(Path path, String size) throws IOException, InterruptedException {
        this.path = Files.createDirectory(path);
        try {
            assumeTrue(mount("size=" + size), "only the administrator may mount a disk");
        } catch (IOException e) {
            abort("there is no mount here");
        }
    }

    private boolean mount(String options) throws IOException, InterruptedException {
        return run("mount", "-t", "tmpfs", "-o", options, "tmpfs", path.toString());
    }

    private static boolean run(String... command) throws IOException, InterruptedException {
        return new ProcessBuilder(command).redirectErrorStream(true).start().waitFor() == 0;
    }

    Path path() {
        return path;
    }

    /** Gives the disk another size. */
    void resize(String size) throws IOException, InterruptedException {
        if (!mount("remount,size=" + size)) {
            throw new IOException("the disk keeps its size");
        }
    }

    /** What this system says of a full disk, in the language of whoever runs the test. */
    String reasonOfAFullDisk() throws IOException {
        Path filler = path.resolve("filler");
        try (OutputStream stream = Files.newOutputStream(filler)) {
            byte[] block = new byte[1 << 12];
            for (int i = 0; i < 1000; i++) {
                stream.write(block);
            }
            throw new AssertionError("the disk takes any number of bytes");
        } catch (IOException e) {
            return e.getMessage();
        } finally {
            Files.delete(filler);
        }
    }

    @Override
    public void close() throws IOException {
        try {
            run("umount", path.toString());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
