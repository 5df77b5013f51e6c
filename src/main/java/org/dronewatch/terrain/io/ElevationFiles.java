package org.dronewatch.terrain.io;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipInputStream;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.RegularFile;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.setting.input.FileKind;
import org.dronewatch.setting.input.LinkOut;
import org.dronewatch.setting.input.PackagedSite;

/**
 * Opens elevation files, whose format is recognised by their first bytes; only SRTM tiles are recognised by their
 * names.
 */
public final class ElevationFiles {
    private static final long MOST_BYTES = 1L << 33;
    private static final int MOST_ENTRIES = 1000;
    private static final int LONGEST_KEY = 16;

    /** Enough to recognise what other programs write, bytes. */
    private static final int START = 128;

    private final Path directory;

    /**
     * Opens files by name.
     *
     * @param directory directory against which relative paths are resolved, that of a scene file or empty for the
     *     working directory
     */
    public ElevationFiles(Path directory) {
        this.directory = directory;
    }

    /** Where a file is. */
    private Path path(String name) {
        Path path;
        try {
            path = directory.resolve(name);
        } catch (InvalidPathException e) {
            throw new InputException("terrain file '" + PlainText.value(name) + "' is not a path: " + e.getReason(), e);
        }
        String obstacle = RegularFile.obstacle(path);
        if (!obstacle.isEmpty()) {
            throw new InputException("terrain file " + PlainText.value(path) + ": " + obstacle);
        }
        LinkOut.refuse(directory, path, "terrain file");
        return path;
    }

    /**
     * The hash of a file's bytes.
     *
     * @throws InputException when it cannot be read, or is too large
     */
    public FileHash hash(String name) {
        if (PackagedSite.isNamed(name)) {
            return packagedHash(name);
        }
        Path path = path(name);
        try (InputStream in = Files.newInputStream(path)) {
            checkSize(name, Files.size(path));
            return FileHash.of(String.valueOf(path.getFileName()), in);
        } catch (IOException e) {
            throw unreadable(name, e);
        }
    }

    private static FileHash packagedHash(String name) {
        try (InputStream in = new ByteArrayInputStream(PackagedSite.bytes(name))) {
            return FileHash.of(PackagedSite.plain(name), in);
        } catch (IOException e) {
            throw unreadable(name, e);
        }
    }

    /**
     * Opens a file.
     *
     * @throws InputException when it is in no known format, or is damaged
     */
    public ElevationFile open(String name) {
        try {
            ElevationBytes bytes = PackagedSite.isNamed(name)
                    ? ElevationBytes.of(PackagedSite.plain(name), PackagedSite.bytes(name))
                    : ElevationBytes.of(name, path(name));
            checkSize(name, bytes.size());
            return open(bytes);
        } catch (IOException e) {
            throw unreadable(name, e);
        }
    }

    private static void checkSize(String name, long bytes) {
        if (bytes > MOST_BYTES) {
            throw new InputException(
                    String.format(Locale.ROOT, "%s: has %,d bytes but must have at most %,d", name, bytes, MOST_BYTES));
        }
    }

    /** The exception for a file that cannot be read, with a message of one line. */
    public static InputException unreadable(String name, IOException problem) {
        if (problem instanceof EOFException) {
            return new InputException(name + ": ends too early: it is truncated or damaged", problem);
        }
        return new InputException(name + ": cannot be read: " + problem.getMessage(), problem);
    }

    private static ElevationFile open(ElevationBytes bytes) throws IOException {
        if (bytes.size() == 0) {
            throw new InputException(bytes.name() + ": is empty");
        }
        byte[] start = bytes.read(0, 8);
        if (TiffDirectory.isTiff(start)) {
            return new GeoTiffFile(bytes);
        }
        if (start[0] == 'P' && start[1] == 'K') {
            return unzipped(bytes);
        }
        if (start[0] == 0x1F && (start[1] & 0xFF) == 0x8B) {
            try (InputStream in = new GZIPInputStream(bytes.open())) {
                return new HgtFile(tile(bytes.name(), in), bytes.shortName().replaceFirst("[.]gz$", ""));
            }
        }
        if (isAsciiGrid(bytes)) {
            return new AsciiGridFile(bytes);
        }
        if (bytes.shortName().endsWith(".hgt")) {
            return new HgtFile(bytes, bytes.shortName());
        }
        byte[] more = bytes.read(0, (int) Math.min(START, bytes.size()));
        Optional<String> misplaced = FileKind.misplaced(bytes.shortName(), more, "world.terrain");
        if (misplaced.isPresent()) {
            throw new InputException(bytes.name() + ": " + misplaced.get());
        }
        throw new InputException(bytes.name()
                + ": is not a GeoTIFF file, an SRTM tile (.hgt, also in .zip or .gz) or an ESRI ASCII grid; gdal_translate "
                + bytes.shortName() + " dem.tif converts most other formats");
    }

    private static boolean isAsciiGrid(ElevationBytes bytes) throws IOException {
        try (InputStream in = bytes.open()) {
            int one = in.read();
            while (one == ' ' || one == '\n' || one == '\r' || one == '\t') {
                one = in.read();
            }
            // Keys may come in any order.
            StringBuilder word = new StringBuilder();
            while (word.length() < LONGEST_KEY && (Character.isLetter(one) || one == '_')) {
                word.append((char) Character.toLowerCase(one));
                one = in.read();
            }
            return AsciiGridFile.KEYS.contains(word.toString());
        }
    }

    private static HgtFile unzipped(ElevationBytes bytes) throws IOException {
        Optional<HgtFile> found = Optional.empty();
        try (ZipInputStream zip = new ZipInputStream(bytes.open())) {
            int entries = 0;
            for (ZipEntry entry = zip.getNextEntry(); entry != null; entry = zip.getNextEntry()) {
                if (++entries > MOST_ENTRIES) {
                    throw new InputException(bytes.name() + ": has more than " + MOST_ENTRIES + " files");
                }
                if (entry.getName().toLowerCase(Locale.ROOT).endsWith(".hgt")) {
                    if (found.isPresent()) {
                        throw new InputException(bytes.name() + ": has several .hgt files but must have one");
                    }
                    found = Optional.of(
                            new HgtFile(tile(bytes.name(), zip), ElevationBytes.shortName(entry.getName())));
                } else if (zip.skip(HgtFile.MOST_BYTES + 1L) > HgtFile.MOST_BYTES) {
                    throw new InputException(bytes.name() + ": '" + PlainText.value(entry.getName())
                            + "' unpacks to more than " + HgtFile.MOST_BYTES + " bytes: leave it out");
                }
            }
        } catch (ZipException | IllegalArgumentException e) {
            throw new InputException(bytes.name() + ": is damaged: " + e.getMessage(), e);
        }
        return found.orElseThrow(() -> new InputException(
                bytes.name() + ": has no .hgt file; unpack it if it holds elevations in another format"));
    }

    /** No more is unpacked than the largest tile has. */
    private static ElevationBytes tile(String name, InputStream in) throws IOException {
        byte[] all = in.readNBytes(HgtFile.MOST_BYTES + 1);
        if (all.length > HgtFile.MOST_BYTES) {
            throw new InputException(
                    name + ": unpacks to more than the " + HgtFile.MOST_BYTES + " bytes of the largest tile");
        }
        return ElevationBytes.of(name, all);
    }
}
