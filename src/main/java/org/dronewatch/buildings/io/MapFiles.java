package org.dronewatch.buildings.io;

import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.zip.GZIPInputStream;
import org.dronewatch.parallel.LongTask;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.RegularFile;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.setting.input.FileKind;
import org.dronewatch.setting.input.HeapBudget;
import org.dronewatch.setting.input.JsonText;
import org.dronewatch.setting.input.LinkOut;
import org.dronewatch.setting.input.PackagedSite;
import tools.jackson.databind.JsonNode;

/** Reads map files; the format is recognised by the first bytes, not by the name. Text may be compressed with gzip. */
public final class MapFiles {
    /** JSON is held in memory as a whole. */
    private static final int MOST_JSON = 256 * 1024 * 1024;

    private static final long MOST_BYTES = 1L << 33;
    private static final int START = 128;

    private static final MapArea NOWHERE = new MapArea(0.0, 0.0, 0.0, 0.0);

    /** Reading a larger file takes seconds. */
    private static final long LONG = 50_000_000;

    private final Path directory;
    private final Consumer<String> progress;

    /**
     * Reads files by name.
     *
     * @param directory directory against which relative paths are resolved, that of a scene file or empty for the
     *     working directory
     */
    public MapFiles(Path directory) {
        this(directory, line -> {});
    }

    /**
     * Reads files by name.
     *
     * @param directory directory against which relative paths are resolved, that of a scene file or empty for the
     *     working directory
     * @param progress receives a line before each file that takes seconds to read, unless it is watched as a
     *     {@link LongTask}
     */
    public MapFiles(Path directory, Consumer<String> progress) {
        this.directory = directory;
        this.progress = progress;
    }

    /**
     * Reads the buildings and woods of a map.
     *
     * @param name name of the file
     * @param area the area of interest; features outside it may be left out
     * @throws InputException with a one-line message when the file is missing, damaged or in no known format
     */
    public MapFeatures read(String name, MapArea area) {
        return read(name, area, false);
    }

    /**
     * Reads a map.
     *
     * @param name name of the file
     * @param area the area of interest; features outside it may be left out
     * @param withLand whether to read the land cover as well; in GeoJSON, areas of land cover are then not taken for
     *     buildings
     * @throws InputException with a one-line message when the file is missing, damaged or in no known format
     */
    public MapFeatures read(String name, MapArea area, boolean withLand) {
        Source source = source(name);
        long size = PackagedSite.isNamed(name) ? 0 : path(name).toFile().length();
        String what = String.format(Locale.ROOT, "buildings: reading %,d MB of the map", size / 1_000_000);
        // Read once for the hash, and once for the content.
        try (LongTask task = LongTask.begin(what, 2 * size, size > LONG, progress)) {
            return read(name, () -> new WatchedStream(source.open(), task), area, withLand);
        }
    }

    private static MapFeatures read(String name, Source source, MapArea area, boolean withLand) {
        try (InputStream bytes = source.open()) {
            FileHash hash = FileHash.of(shortName(name), bytes);
            byte[] start = start(source);
            if (PbfBlocks.isPbf(start)) {
                return osm(
                        "OpenStreetMap PBF",
                        PackagedSite.plain(name),
                        source,
                        area,
                        withLand,
                        hash,
                        (in, target) -> OsmPbf.read(PackagedSite.plain(name), in, target));
            }
            String text = startText(start);
            if (text.startsWith("<")) {
                return osm(
                        "OpenStreetMap XML",
                        PackagedSite.plain(name),
                        source,
                        area,
                        withLand,
                        hash,
                        (in, target) -> OsmXml.read(PackagedSite.plain(name), in, target));
            }
            if (isJson(text)) {
                return json(name, source, withLand, hash);
            }
            Optional<String> misplaced = FileKind.misplaced(shortName(name), start, "world.buildings");
            if (misplaced.isPresent()) {
                throw new InputException(name + ": " + misplaced.get());
            }
            throw new InputException(name
                    + ": is not OpenStreetMap XML, OpenStreetMap PBF, GeoJSON or CityJSON; 'ogr2ogr buildings.geojson "
                    + shortName(name) + "' converts most other formats");
        } catch (EOFException e) {
            throw new InputException(name + ": ends too early: it is truncated or damaged", e);
        } catch (IOException e) {
            throw new InputException(name + ": cannot be read: " + PlainText.line(String.valueOf(e.getMessage())), e);
        }
    }

    /**
     * Whether the scene has to state the coordinate system of a map, since neither its format nor the file does.
     *
     * @param name name of the file
     * @throws InputException with a one-line message when the file is missing, damaged or in no known format
     */
    public boolean needsCrs(String name) {
        try {
            // Maps of OpenStreetMap, which may be large, never do.
            return isJson(startText(start(source(name))))
                    && read(name, source(name), NOWHERE, true).system().isUnknown();
        } catch (EOFException e) {
            throw new InputException(name + ": ends too early: it is truncated or damaged", e);
        } catch (IOException e) {
            throw new InputException(name + ": cannot be read: " + PlainText.line(String.valueOf(e.getMessage())), e);
        }
    }

    /**
     * The hash of a file's bytes.
     *
     * @throws InputException when it cannot be read
     */
    public FileHash hash(String name) {
        try (InputStream bytes = source(name).open()) {
            return FileHash.of(shortName(name), bytes);
        } catch (IOException e) {
            throw new InputException(name + ": cannot be read: " + PlainText.line(String.valueOf(e.getMessage())), e);
        }
    }

    /** Where the bytes of a file come from. */
    private interface Source {
        InputStream open() throws IOException;
    }

    private Source source(String name) {
        if (PackagedSite.isNamed(name)) {
            byte[] bytes = PackagedSite.bytes(name);
            return () -> new ByteArrayInputStream(bytes);
        }
        Path path = path(name);
        return () -> Files.newInputStream(path);
    }

    /** The last part of a name. */
    private static String shortName(String name) {
        return PackagedSite.isNamed(name)
                ? PackagedSite.plain(name)
                : String.valueOf(Path.of(name).getFileName());
    }

    private Path path(String name) {
        Path path;
        try {
            path = directory.resolve(name);
        } catch (InvalidPathException e) {
            throw new InputException("map file '" + PlainText.value(name) + "' is not a path: " + e.getReason(), e);
        }
        String obstacle = RegularFile.obstacle(path);
        if (!obstacle.isEmpty()) {
            throw new InputException("map file " + PlainText.value(path) + ": " + obstacle);
        }
        LinkOut.refuse(directory, path, "map file");
        return path;
    }

    private static String startText(byte[] start) {
        return new String(start, StandardCharsets.UTF_8).replace("\uFEFF", "").strip();
    }

    private static boolean isJson(String start) {
        return start.startsWith("{");
    }

    private static byte[] start(Source source) throws IOException {
        try (InputStream in = unpacked(source)) {
            return in.readNBytes(START);
        }
    }

    private static InputStream unpacked(Source source) throws IOException {
        InputStream in = new BufferedInputStream(source.open(), 1 << 16);
        in.mark(2);
        boolean isPacked = in.read() == 0x1F && in.read() == 0x8B;
        in.reset();
        return isPacked ? new LimitedStream(new GZIPInputStream(in, 1 << 16), MOST_BYTES) : in;
    }

    /** Reads the elements of a stream. */
    private interface Elements {
        void read(InputStream in, OsmElements target) throws IOException;
    }

    private static MapFeatures osm(
            String format, String name, Source source, MapArea area, boolean withLand, FileHash hash, Elements elements)
            throws IOException {
        OsmLand.Pass pass = target -> {
            try (InputStream in = unpacked(source)) {
                elements.read(in, target);
            }
        };
        OsmFeatures features = new OsmFeatures(name, area, false, budget(name));
        pass.read(features);
        if (features.isIncomplete()) {
            // Ways come before their nodes, as Overpass writes them.
            features = new OsmFeatures(name, area, true, budget(name));
            pass.read(features);
        }
        // Before nodes elsewhere are added.
        List<MapFeature> buildings = features.features();
        return new MapFeatures(
                buildings,
                Optional.empty(),
                withLand ? OsmLand.read(name, features.nodes(), pass) : MapLand.NONE,
                features.leftOut(),
                format,
                features.system(),
                hash);
    }

    private static MapFeatures json(String name, Source source, boolean withLand, FileHash hash) throws IOException {
        // While it is read, there are two copies of it.
        int most = (int) Math.min(MOST_JSON, Runtime.getRuntime().maxMemory() / 8);
        byte[] all;
        try (InputStream in = unpacked(source)) {
            all = in.readNBytes(most + 1);
        }
        if (all.length > most) {
            throw new InputException(
                    String.format(Locale.ROOT, "%s: has more than %,d bytes of JSON: clip it to the site", name, most)
                            + (most < MOST_JSON ? ", or give Java more memory, as in java -Xmx4g" : ""));
        }
        HeapBudget budget = budget(name);
        JsonNode root = JsonText.read(name, all, budget);
        if (root.path("type").asString("").equals("CityJSON")) {
            // Solids are closed by their sides, which take as much again.
            budget.take(JsonText.memory(all));
            return CityJsonFile.read(name, root, hash);
        }
        return GeoJsonFile.read(name, root, withLand, hash);
    }

    private static HeapBudget budget(String name) {
        return new HeapBudget(name, "clip it to the site, as with 'osmium extract'");
    }
}
