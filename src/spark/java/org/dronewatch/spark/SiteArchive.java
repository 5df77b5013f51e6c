package org.dronewatch.spark;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.zip.ZipEntry;
import java.util.zip.ZipInputStream;
import java.util.zip.ZipOutputStream;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * The files in the directory of a campaign file and below it, as one archive, in which they reach the executors. Hidden
 * files, the results of campaigns, and links that lead elsewhere are left out.
 */
final class SiteArchive {
    /** The greatest number of files. */
    static final int MOST_FILES = 10_000;

    /** The greatest size of all files together, bytes. */
    static final long MOST_BYTES = 1L << 30;

    private static final int BUFFER_BYTES = 1 << 16;

    private SiteArchive() {}

    /**
     * Packs a directory.
     *
     * @throws InputException when it cannot be read, or is larger than the limits
     */
    static byte[] pack(Path directory) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
            Files.walkFileTree(directory, new Packing(directory, directory.toRealPath(), zip));
        } catch (IOException e) {
            throw new InputException(PlainText.value(directory) + ": cannot be packed: " + e.getMessage(), e);
        }
        return bytes.toByteArray();
    }

    private static final class Packing extends SimpleFileVisitor<Path> {
        private final Path directory;
        private final Path real;
        private final ZipOutputStream zip;
        private int files;
        private long bytes;

        Packing(Path directory, Path real, ZipOutputStream zip) {
            this.directory = directory;
            this.real = real;
            this.zip = zip;
        }

        @Override
        public FileVisitResult preVisitDirectory(Path path, BasicFileAttributes attributes) {
            boolean isResult = Files.exists(path.resolve("plan.json")) && Files.isDirectory(path.resolve("chunks"));
            boolean isLeftOut = !path.equals(directory) && (isHidden(path) || isResult);
            return isLeftOut ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
        }

        private static boolean isHidden(Path path) {
            return String.valueOf(path.getFileName()).startsWith(".");
        }

        @Override
        public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) throws IOException {
            if (!isHidden(file)
                    && Files.isRegularFile(file)
                    && file.toRealPath().startsWith(real)) {
                files++;
                check(Files.size(file));
                zip.putNextEntry(
                        new ZipEntry(directory.relativize(file).toString().replace('\\', '/')));
                bytes += Files.copy(file, zip);
                check(0);
            }
            return FileVisitResult.CONTINUE;
        }

        private void check(long more) {
            if (files > MOST_FILES || bytes + more > MOST_BYTES) {
                throw new InputException(PlainText.value(directory) + ": has more than 10,000 files or 1 GiB, which is"
                        + " too much to send: keep the campaign in a separate directory, or share the directory"
                        + " and name the campaign file there with --conf " + SparkCluster.SHARED + "=PATH");
            }
        }
    }

    /**
     * Unpacks an archive.
     *
     * @param target a new directory
     * @throws IOException when a file cannot be written, would lie elsewhere, or the archive is larger than the limits
     */
    static void unpack(byte[] archive, Path target) throws IOException {
        long left = MOST_BYTES;
        int files = 0;
        try (ZipInputStream zip = new ZipInputStream(new ByteArrayInputStream(archive))) {
            for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
                Path file = target.resolve(entry.getName()).normalize();
                if (!file.startsWith(target) || file.equals(target)) {
                    throw new IOException(PlainText.value(entry.getName()) + " would lie outside the directory");
                }
                if (++files > MOST_FILES) {
                    throw new IOException("more than " + MOST_FILES + " files");
                }
                Path parent = file.getParent();
                if (parent != null) {
                    Files.createDirectories(parent);
                }
                left -= copy(zip, file, left);
            }
        }
    }

    private static long copy(InputStream from, Path file, long most) throws IOException {
        byte[] buffer = new byte[BUFFER_BYTES];
        long copied = 0;
        try (OutputStream to = Files.newOutputStream(file)) {
            for (int read = from.read(buffer); read >= 0; read = from.read(buffer)) {
                copied += read;
                if (copied > most) {
                    throw new IOException("more than 1 GiB");
                }
                to.write(buffer, 0, read);
            }
        }
        return copied;
    }
}
