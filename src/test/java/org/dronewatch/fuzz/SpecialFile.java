package org.dronewatch.fuzz;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Locale;

/** What a file name may lead to besides a small file of text; made when a case runs, for it cannot be stored. */
public final class SpecialFile {
    private static final Path DEVICES = Path.of("/dev");

    private SpecialFile() {}

    /**
     * Makes one.
     *
     * @param kind {@code fifo}, {@code directory}, {@code unreadable}, {@code link:TARGET}, or a large model:
     *     {@code polygon:CORNERS}, {@code face-line:CORNERS}, {@code materials:COUNT}, {@code libraries:COUNT},
     *     {@code continued:LINES}, or {@code long-line:CHARACTERS}; or any text, {@code letters:CHARACTERS}, or
     *     zeros that take no room on the disk, {@code zeros:BYTES}
     * @param path where
     * @param directory what {@code {}} in the target of a link stands for
     * @throws UnsupportedOperationException if the system or its file system has no such files
     */
    public static void make(String kind, Path path, Path directory) throws IOException {
        String name = kind.contains(":") ? kind.substring(0, kind.indexOf(':')) : kind;
        String detail = kind.substring(Math.min(kind.length(), name.length() + 1));
        Files.createDirectories(path.getParent());
        switch (name) {
            case "fifo" -> makeFifo(path);
            case "directory" -> Files.createDirectories(path);
            case "unreadable" -> {
                Files.writeString(path, "world: {}\n");
                Files.setPosixFilePermissions(path, PosixFilePermissions.fromString("---------"));
            }
            case "link" -> makeLink(path, Path.of(detail.replace(FuzzCase.DIRECTORY, directory.toString())));
            case "zeros" -> {
                try (RandomAccessFile file = new RandomAccessFile(path.toFile(), "rw")) {
                    file.setLength(Long.parseLong(detail));
                }
            }
            default -> Files.writeString(path, largeFile(name, Integer.parseInt(detail)));
        }
    }

    private static void makeFifo(Path path) throws IOException {
        Process process;
        try {
            process = new ProcessBuilder("mkfifo", path.toString()).start();
        } catch (IOException e) {
            throw new UnsupportedOperationException("there is no mkfifo here", e);
        }
        try {
            if (process.waitFor() != 0) {
                throw new UnsupportedOperationException("there are no named pipes here");
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IOException("interrupted", e);
        }
    }

    private static void makeLink(Path path, Path target) throws IOException {
        if (target.startsWith(DEVICES) && !Files.exists(target)) {
            throw new UnsupportedOperationException("there is no " + target + " here");
        }
        try {
            Files.createSymbolicLink(path, target);
        } catch (FileAlreadyExistsException | NoSuchFileException e) {
            throw e;
        } catch (FileSystemException e) {
            throw new UnsupportedOperationException("there are no symbolic links here", e);
        }
    }

    /** A large model file of some kind. */
    static String largeFile(String kind, int size) {
        StringBuilder text = new StringBuilder();
        switch (kind) {
            case "polygon" -> polygon(text, size);
            case "face-line" ->
                text.append("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf ")
                        .append("1 ".repeat(size))
                        .append("x\n");
            case "materials" -> materials(text, size);
            case "libraries" -> {
                text.append("mtllib model.mtl\n".repeat(size));
                text.append("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
            }
            case "continued" ->
                text.append("v 0 0 0\nv 1 0 0\nv 0 1 0\n")
                        .append("f 1 2 3 \\\n")
                        .append("1 2 3 \\\n".repeat(size))
                        .append("1\n");
            case "letters" -> text.append("x".repeat(size)).append('\n');
            case "long-line" ->
                text.append("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl ")
                        .append("x".repeat(size))
                        .append("\nf 1 2 3\n");
            default -> throw new IllegalArgumentException("no special file '" + kind + "'");
        }
        return text.toString();
    }

    private static void polygon(StringBuilder text, int corners) {
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * i / corners;
            text.append(String.format(Locale.ROOT, "v %.9f %.9f 0\n", 10 * Math.cos(angle), 10 * Math.sin(angle)));
        }
        text.append('f');
        for (int i = 1; i <= corners; i++) {
            text.append(' ').append(i);
        }
        text.append('\n');
    }

    private static void materials(StringBuilder text, int count) {
        text.append("mtllib model.mtl\n");
        for (int i = 0; i < count; i++) {
            int row = i / 100;
            int first = 3 * i + 1;
            text.append("usemtl m").append(i);
            for (int[] corner : new int[][] {{0, 0}, {1, 0}, {0, 1}}) {
                text.append("\nv ")
                        .append(i % 100 + corner[0])
                        .append(' ')
                        .append(row + corner[1])
                        .append(" 0");
            }
            text.append("\nf ")
                    .append(first)
                    .append(' ')
                    .append(first + 1)
                    .append(' ')
                    .append(first + 2)
                    .append('\n');
        }
    }
}
