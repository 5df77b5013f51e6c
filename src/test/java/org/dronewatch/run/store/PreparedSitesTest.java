package org.dronewatch.run.store;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronewatch.buildings.BuildingSettings;
import org.dronewatch.buildings.LoadedBuildings;
import org.dronewatch.geo.Origin;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.SahCost;
import org.dronewatch.kdtree.TreeParts;
import org.dronewatch.setting.InputException;
import org.dronewatch.terrain.TerrainSettings;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A site that was prepared once is the same as one that is prepared anew, whatever happens to its files meanwhile. */
class PreparedSitesTest {
    private static final Origin ORIGIN =
            Origin.at(Math.toRadians(50), Math.toRadians(15)).withHeight(200.0);
    private static final TerrainSettings TERRAIN =
            TerrainSettings.of("dem.asc").withCrs("EPSG:4326").withAccuracy(0.0);
    private static final BuildingSettings BUILDINGS =
            BuildingSettings.of("town.osm").withRadius(300).withLandCover(true);

    private static final String MAP =
            """
            <osm version="0.6">
            <node id="1" lat="50.0001" lon="15.0001"/><node id="2" lat="50.0001" lon="15.0009"/>
            <node id="3" lat="50.0005" lon="15.0009"/><node id="4" lat="50.0005" lon="15.0001"/>
            <node id="5" lat="50.0002" lon="15.0003"/><node id="6" lat="50.0002" lon="15.0006"/>
            <node id="7" lat="50.0004" lon="15.0006"/>
            <way id="1"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="1"/></way>
            <way id="2"><nd ref="5"/><nd ref="6"/><nd ref="7"/><nd ref="5"/></way>
            <way id="3"><nd ref="5"/><nd ref="6"/><nd ref="7"/><nd ref="5"/><tag k="building" v="yes"/>
              <tag k="height" v="tall"/></way>
            <way id="4"><nd ref="1"/><nd ref="5"/><nd ref="6"/><nd ref="1"/><tag k="natural" v="water"/></way>
            <relation id="1"><member type="way" ref="1" role="outer"/><member type="way" ref="2" role="inner"/>
              <tag k="type" v="multipolygon"/><tag k="building" v="yes"/><tag k="height" v="12"/>
              <tag k="name" v="Zámek"/></relation>
            </osm>
            """;

    @TempDir
    private static Path site;

    private static PreparedTerrain terrain;
    private static LoadedBuildings buildings;
    private static KDTree tree;

    @TempDir
    private Path place;

    private final List<String> notes = new ArrayList<>();

    /** A hill with a hole, a building with a courtyard, and another in it. */
    @BeforeAll
    static void prepareWithoutStore() throws IOException {
        Files.writeString(site.resolve("dem.asc"), grid(site, 230.0));
        Files.writeString(site.resolve("town.osm"), MAP);
        PreparedSites without = new PreparedSites(site, noStore(), new TreeMemory(), 1, line -> {});
        terrain = without.terrain(TERRAIN, ORIGIN);
        buildings = without.buildings(BUILDINGS, ORIGIN, Optional.of(TERRAIN), Optional.of(terrain));
        tree = without.tree(terrain.terrain().mesh(), SahCost.DEFAULT);
        assertThat(terrain.terrain().warnings().size() + buildings.warnings().size())
                .isPositive();
        assertThat(buildings.outlines().get(1).courts().size()
                        + buildings.outlines().get(0).courts().size())
                .isEqualTo(1);
        assertThat(buildings.landCover().orElseThrow().isAnywhere()).isTrue();
    }

    private static String grid(Path directory, double top) {
        StringBuilder text = new StringBuilder(
                "ncols 23\nnrows 23\nxllcenter 14.9989\nyllcenter 49.9989\n" + "cellsize 0.0001\nNODATA_value -9999\n");
        for (int i = 0; i < 23 * 23; i++) {
            double height = top - 0.01 * Math.hypot(i % 23 - 11, i / 23 - 11) + i * 7 % 13;
            text.append(i == 100 ? "-9999" : String.format(Locale.ROOT, "%.2f", height))
                    .append(i % 23 == 22 ? '\n' : ' ');
        }
        return text.toString();
    }

    private static SiteStore noStore() {
        return new SiteStore(Optional.empty(), 1 << 30, 0.0, line -> {});
    }

    private SiteStore store(long mostBytes) {
        return new SiteStore(Optional.of(place), mostBytes, 0.0, notes::add);
    }

    private PreparedSites sites() {
        return new PreparedSites(site, store(1 << 30), new TreeMemory(), 1, notes::add);
    }

    /** Prepares everything, and compares it with what was prepared without a store. */
    private void isAsWithoutStore(PreparedSites sites) {
        PreparedTerrain other = sites.terrain(TERRAIN, ORIGIN);
        LoadedBuildings built = sites.buildings(BUILDINGS, ORIGIN, Optional.of(TERRAIN), Optional.of(other));
        assertThat(other).usingRecursiveComparison().isEqualTo(terrain);
        assertThat(built).usingRecursiveComparison().isEqualTo(buildings);
        KDTree grown = sites.tree(other.terrain().mesh(), SahCost.DEFAULT);
        assertThat(grown).usingRecursiveComparison().isEqualTo(tree);
    }

    private List<Path> files() throws IOException {
        if (!Files.isDirectory(place)) {
            return List.of();
        }
        try (Stream<Path> all = Files.list(place)) {
            return all.sorted().toList();
        }
    }

    @Test
    void theSecondStartFindsWhatTheFirstPrepared() throws IOException {
        isAsWithoutStore(sites());
        List<Path> kept = files();
        assertThat(kept)
                .extracting(file -> file.getFileName().toString().replaceFirst("-.*[.]", " "))
                .containsExactly("buildings site", "terrain site", "tree site");
        for (Path file : kept) {
            Files.setLastModifiedTime(file, FileTime.from(Instant.EPOCH));
        }

        isAsWithoutStore(sites());

        // The time of use is marked, here and when a file is written; whatIsFoundIsTaken tells them apart.
        assertThat(files()).isEqualTo(kept);
        assertThat(times(kept)).doesNotContain(FileTime.from(Instant.EPOCH));
        assertThat(notes).isEmpty();
    }

    @Test
    void aProcessBuildsATreeOnceEvenWithoutAStore() {
        TreeMemory memory = new TreeMemory();
        PreparedSites first = new PreparedSites(site, noStore(), memory, 1, notes::add);
        PreparedSites second = new PreparedSites(site, noStore(), memory, 1, notes::add);
        KDTree grown = first.tree(terrain.terrain().mesh(), SahCost.DEFAULT);
        KDTree again = second.tree(terrain.terrain().mesh(), SahCost.DEFAULT);
        KDTree other = second.tree(buildings.mesh(), SahCost.DEFAULT);

        assertThat(TreeParts.of(again).nodes()).isSameAs(TreeParts.of(grown).nodes());
        assertThat(again).usingRecursiveComparison().isEqualTo(tree);
        assertThat(other).usingRecursiveComparison().isEqualTo(KDTree.of(buildings.mesh()));
    }

    private static List<FileTime> times(List<Path> files) throws IOException {
        List<FileTime> times = new ArrayList<>();
        for (Path file : files) {
            times.add(Files.getLastModifiedTime(file));
        }
        return times;
    }

    /** Another value under the same key proves that it is taken. */
    @Test
    void whatIsFoundIsTaken() {
        PreparedTerrain other = sites().terrain(TERRAIN.withAccuracy(1.0), ORIGIN);
        StoreKey key = StoreKey.of("terrain", terrain.terrain().files(), TERRAIN, ORIGIN);
        store(1 << 30).keep(() -> key, StoredForms.TERRAIN, other, 1.0);

        assertThat(sites().terrain(TERRAIN, ORIGIN)).usingRecursiveComparison().isEqualTo(other);
    }

    @Test
    void whatDependsOnSomethingElseIsPreparedAnew() throws IOException {
        PreparedTerrain first = sites().terrain(TERRAIN, ORIGIN);
        assertThat(files()).hasSize(1);
        sites().terrain(TERRAIN.withAccuracy(0.5), ORIGIN);
        sites().terrain(TERRAIN.withMaterial("snow"), ORIGIN);
        sites().terrain(TERRAIN, ORIGIN.withHeight(201.0));
        assertThat(files()).hasSize(4);

        Path copy = Files.createDirectory(place.resolve("copy"));
        Files.writeString(copy.resolve("dem.asc"), grid(copy, 231.0));
        PreparedTerrain changed =
                new PreparedSites(copy, store(1 << 30), new TreeMemory(), 1, notes::add).terrain(TERRAIN, ORIGIN);
        assertThat(changed.terrain().mesh().bounds().maxZ())
                .isGreaterThan(first.terrain().mesh().bounds().maxZ() + 0.9f);
        sites().buildings(BUILDINGS, ORIGIN, Optional.of(TERRAIN), Optional.of(first));
        sites().buildings(BUILDINGS, ORIGIN, Optional.of(TERRAIN), Optional.of(changed));
        sites().buildings(BUILDINGS, ORIGIN, Optional.empty(), Optional.empty());
        assertThat(files()).hasSize(4 + 1 + 3 + 1);

        BuildingSettings plain = BUILDINGS.withLandCover(false);
        LoadedBuildings without = sites().buildings(plain, ORIGIN, Optional.of(TERRAIN), Optional.of(first));
        assertThat(without.landCover()).isEmpty();
        assertThat(files()).hasSize(4 + 1 + 3 + 1 + 1);
    }

    @Test
    void aFileThatCannotBeReadIsReportedAsWithoutStore() {
        sites().terrain(TERRAIN, ORIGIN);
        assertThatThrownBy(() -> sites().terrain(TerrainSettings.of("missing.asc"), ORIGIN))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("missing.asc: no such file");
        assertThatThrownBy(() -> sites().buildings(
                                BuildingSettings.of("missing.osm"), ORIGIN, Optional.empty(), Optional.empty()))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("missing.osm: no such file");
    }

    @Test
    void damagedFilesAreWrittenAnew() throws IOException {
        isAsWithoutStore(sites());
        SplittableRandom random = new SplittableRandom(11);
        for (Path file : files()) {
            byte[] right = Files.readAllBytes(file);
            for (int round = 0; round < 9; round++) {
                int at = round == 0 ? 0 : random.nextInt(right.length);
                byte[] wrong = round % 3 == 0
                        ? Arrays.copyOf(right, at)
                        : Arrays.copyOf(right, right.length + (round % 3 == 1 ? 0 : 9));
                if (round % 3 == 1) {
                    wrong[at] ^= (byte) (1 << random.nextInt(8));
                }
                Files.write(file, wrong);
                String what = file.getFileName() + ", seed 11, round " + round;
                assertThat(found(file)).as(what).isFalse();
            }
        }
        isAsWithoutStore(sites());
        for (Path file : files()) {
            assertThat(found(file)).isTrue();
        }
        assertThat(notes).isEmpty();
    }

    private boolean found(Path file) {
        String name = file.getFileName().toString();
        String kind = name.replaceFirst("-.*", "");
        StoreKey key = new StoreKey(kind, name.substring(kind.length() + 1, name.length() - ".site".length()));
        SiteStore store = store(1 << 30);
        return switch (kind) {
            case "terrain" -> store.find(key, StoredForms.TERRAIN).isPresent();
            case "buildings" -> store.find(key, StoredForms.BUILDINGS).isPresent();
            default -> store.find(key, StoredForms.TREE).isPresent();
        };
    }

    /** Files with a right checksum, whose lengths would fill any memory, or are of another version. */
    @Test
    void hostileFilesAreNotTaken() throws IOException {
        StoreKey key = new StoreKey("tree", "0".repeat(64));
        for (int length : new int[] {Integer.MAX_VALUE, -1, Integer.MIN_VALUE, 1 << 28}) {
            write(key, StoredForms.VERSION, key.fileName(), target -> target.addInt(length));
            assertThat(store(1 << 30).find(key, StoredForms.TREE)).isEmpty();
        }
        TreeParts parts = TreeParts.of(tree);
        write(key, StoredForms.VERSION + 1, key.fileName(), target -> StoredForms.TREE.write(parts, target));
        assertThat(store(1 << 30).find(key, StoredForms.TREE)).isEmpty();
        write(key, StoredForms.VERSION, "tree-1.site", target -> StoredForms.TREE.write(parts, target));
        assertThat(store(1 << 30).find(key, StoredForms.TREE)).isEmpty();
        write(key, StoredForms.VERSION, key.fileName(), target -> StoredForms.TREE.write(parts, target));
        assertThat(store(1 << 30).find(key, StoredForms.TREE)).isPresent();
        assertThat(store(1 << 10).find(key, StoredForms.TREE))
                .as("larger than all together may be")
                .isEmpty();
    }

    /** A tree of other triangles under the right key, as nobody but an attacker would write it. */
    @Test
    void aTreeThatIsNoneIsBuiltAnew() {
        StoreKey key = StoreKey.of("tree", terrain.terrain().mesh(), SahCost.DEFAULT);
        TreeParts wrong = new TreeParts(new long[] {5}, new int[0], new int[0], 0);
        store(1 << 30).keep(() -> key, StoredForms.TREE, wrong, 1.0);

        assertThat(sites().tree(terrain.terrain().mesh(), SahCost.DEFAULT))
                .usingRecursiveComparison()
                .isEqualTo(tree);
        assertThat(store(1 << 30).find(key, StoredForms.TREE).orElseThrow().depth())
                .isEqualTo(tree.depth());
    }

    private interface Content {
        void addTo(StoreWriter target) throws IOException;
    }

    private void write(StoreKey key, int version, String name, Content content) throws IOException {
        try (FileChannel channel = FileChannel.open(
                place.resolve(key.fileName()),
                StandardOpenOption.CREATE,
                StandardOpenOption.WRITE,
                StandardOpenOption.TRUNCATE_EXISTING)) {
            StoreWriter target = new StoreWriter(channel);
            target.addInt(StoredForms.MAGIC);
            target.addInt(version);
            target.addText(name);
            content.addTo(target);
            target.finish();
        }
    }

    @Test
    void whereNothingCanBeWrittenOneLineSaysSo() throws IOException {
        Path file = Files.writeString(place.resolve("file"), "no directory");
        SiteStore store = new SiteStore(Optional.of(file.resolve("cache")), 1 << 30, 0.0, notes::add);

        isAsWithoutStore(new PreparedSites(site, store, new TreeMemory(), 1, notes::add));

        assertThat(notes).hasSize(1);
        assertThat(notes.get(0))
                .startsWith("prepared data are not kept for the next start: " + file.resolve("cache"))
                .doesNotContain("Exception");

        SiteStore inTheWay = new SiteStore(Optional.of(file), 1 << 30, 0.0, notes::add);
        isAsWithoutStore(new PreparedSites(site, inTheWay, new TreeMemory(), 1, notes::add));
        assertThat(notes.get(1)).contains("next start: " + file + " is a file (--no-cache avoids the attempt)");
    }

    /** The stores of a process share a directory: models, and fields of a coverage. */
    @Test
    void oneLineSaysSoForAllStoresOfAProcess() throws IOException {
        Path file = Files.writeString(place.resolve("file"), "no directory");
        StorePlace shared = new StorePlace(Optional.of(file.resolve("cache")));
        for (int i = 0; i < 2; i++) {
            StoreKey key = new StoreKey("tree", String.valueOf(i).repeat(64));
            SiteStore.standard(shared, 0.0, notes::add).keep(() -> key, StoredForms.TREE, TreeParts.of(tree), 1.0);
        }
        assertThat(notes).singleElement().asString().contains("are not kept for the next start");
    }

    @Test
    void whatWasUsedLongestAgoIsDeleted() throws IOException {
        Path foreign = Files.writeString(place.resolve("terrain-notes.site"), "somebody's");
        Path left = Files.writeString(
                place.resolve("tree-" + "0".repeat(64) + ".site123.part"), "of a process that has ended");
        Files.setLastModifiedTime(left, FileTime.from(Instant.EPOCH));
        TreeParts parts = TreeParts.of(tree);
        List<StoreKey> keys = IntStream.range(0, 4)
                .mapToObj(i -> new StoreKey("tree", String.valueOf(i).repeat(64)))
                .toList();
        SiteStore roomy = store(1 << 30);
        for (int i = 0; i < 3; i++) {
            StoreKey key = keys.get(i);
            roomy.keep(() -> key, StoredForms.TREE, parts, 1.0);
            Files.setLastModifiedTime(place.resolve(key.fileName()), FileTime.from(Instant.ofEpochSecond(1000 + i)));
        }
        assertThat(roomy.find(keys.get(0), StoredForms.TREE)).isPresent();
        long one = Files.size(place.resolve(keys.get(0).fileName()));

        store(2 * one + one / 2).keep(() -> keys.get(3), StoredForms.TREE, parts, 1.0);

        assertThat(keys.stream().map(key -> Files.exists(place.resolve(key.fileName()))))
                .containsExactly(true, false, false, true);
        assertThat(foreign).exists();
        assertThat(left).doesNotExist();
        store(one - 1).keep(() -> keys.get(1), StoredForms.TREE, parts, 1.0);
        assertThat(place.resolve(keys.get(1).fileName())).doesNotExist();
    }

    @Test
    void whatTakesNoTimeIsNotKept() throws IOException {
        SiteStore store = new SiteStore(Optional.of(place), 1 << 30, 1e9, notes::add);

        new PreparedSites(site, store, new TreeMemory(), 1, notes::add).terrain(TERRAIN, ORIGIN);

        assertThat(files()).isEmpty();
    }

    @Test
    void severalWritersAndReadersDoNotDisturbEachOther() throws IOException {
        StoreKey key = new StoreKey("tree", "0".repeat(64));
        TreeParts parts = TreeParts.of(tree);

        List<Optional<TreeParts>> found = IntStream.range(0, 24)
                .parallel()
                .mapToObj(i -> {
                    store(1 << 30).keep(() -> key, StoredForms.TREE, parts, 1.0);
                    return store(1 << 30).find(key, StoredForms.TREE);
                })
                .toList();

        assertThat(found).allSatisfy(one -> assertThat(one)
                .hasValueSatisfying(
                        tree -> assertThat(tree).usingRecursiveComparison().isEqualTo(parts)));
        assertThat(files()).containsExactly(place.resolve(key.fileName()));
        assertThat(notes).isEmpty();
    }
}
