package org.dronewatch.analysis.layer;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldColumns;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.store.SiteStore;
import org.dronewatch.run.store.StoreKey;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.run.store.StoreReader;
import org.dronewatch.run.store.StoreWriter;
import org.dronewatch.run.store.StoredForm;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.CanonicalSettings;
import org.dronewatch.setting.input.FileHash;

/**
 * Keeps the assessments of each sensor at each height in the user's cache directory, where they are found again for an
 * identical sensor: the key is a hash of the world with all of its files, the drone, the sensor, the seed, the courses,
 * the grid, and this program's code. Assessments of sensors and drones from other jars are not kept, since their code
 * is not part of the hash. Not thread-safe.
 */
public final class LayerStore {
    /** A store that keeps nothing. */
    public static final LayerStore NONE = new LayerStore(Optional.empty(), "");

    /** What takes less to assess is not kept, s. */
    private static final double WORTH = 0.05;

    private static final String KIND = "field";
    private static final String EXCESS = "excess";
    private static final double NANO = 1e-9;

    private final Optional<SiteStore> store;

    /** The mesh of the world that was hashed last, since hashing a large site takes a tenth of a second. */
    private TriangleMesh hashed;

    private String hash = "";

    /** Everything on which the assessments of all sensors depend. */
    private final String world;

    private LayerStore(Optional<SiteStore> store, String world) {
        this.store = store;
        this.world = world;
    }

    /**
     * A store for a scene.
     *
     * @param files the files that were read for the scene, by their names in the settings
     */
    public static LayerStore of(SceneSettings settings, Map<String, List<FileHash>> files, SiteStore store) {
        return store.isOn() ? of(settings, files, Optional.of(store)) : NONE;
    }

    /**
     * This store for another scene, such as one in other weather.
     *
     * @param files the files that were read for the scene, by their names in the settings
     */
    public LayerStore under(SceneSettings settings, Map<String, List<FileHash>> files) {
        return store.isPresent() ? of(settings, files, store) : NONE;
    }

    private static LayerStore of(SceneSettings settings, Map<String, List<FileHash>> files, Optional<SiteStore> store) {
        if (!OwnCode.isAll(settings.world())) {
            return NONE;
        }
        StringBuilder text = new StringBuilder(CanonicalSettings.of(settings.world()));
        files.entrySet().stream().sorted(Map.Entry.comparingByKey()).forEach(one -> text.append(one)
                .append('\n'));
        return new LayerStore(store, text.toString());
    }

    /** This store for assessments that also depend on the signals interpolated between the cells of a field. */
    public LayerStore about(FieldGrid grid, List<Course> courses) {
        return store.isEmpty() ? this : new LayerStore(store, world + grid + courses);
    }

    /**
     * A store that keeps whatever takes more than 50 ms to compute.
     *
     * @param notes receives a line when a file cannot be written
     */
    public static SiteStore standard(StorePlace place, Consumer<String> notes) {
        return SiteStore.standard(place, WORTH, notes);
    }

    /**
     * The signals interpolated between the cells of a field: taken from this store if they are there, otherwise
     * computed on the {@link Workers} of the calling thread; empty if each cell is assessed.
     *
     * @param plan description of where the columns are, which is part of the key
     * @param progress receives the number of cells done since the last call; in total, all cells if levels may be
     *     interpolated, otherwise none
     */
    public Optional<ExcessMap> excess(FieldProbe probe, FieldColumns columns, String plan, IntConsumer progress) {
        SurveyProgress whole = SurveyProgress.of(probe, columns, progress);
        Optional<ExcessMap> map = excess(probe, columns, plan, whole);
        whole.finish();
        return map;
    }

    private Optional<ExcessMap> excess(FieldProbe probe, FieldColumns columns, String plan, SurveyProgress progress) {
        if (!isKept(probe) || !ExcessSurvey.isWorthwhile(probe, columns)) {
            return ExcessSurvey.of(probe, columns, progress);
        }
        StoreKey key = key(EXCESS, probe, plan, "");
        Optional<ExcessMap> former = store.orElseThrow().find(key, ExcessForm.FORM);
        if (former.isPresent()) {
            return former;
        }
        long start = System.nanoTime();
        Optional<ExcessMap> map = ExcessSurvey.of(probe, columns, progress);
        double seconds = NANO * (System.nanoTime() - start);
        map.ifPresent(its -> store.orElseThrow().keep(() -> key, ExcessForm.FORM, its, seconds));
        return map;
    }

    private boolean isKept(FieldProbe probe) {
        return store.isPresent()
                && OwnCode.isAll(probe.settings())
                && OwnCode.isAll(probe.drone().settings());
    }

    /**
     * Assesses one height of a layer, except for what the store has kept of it.
     *
     * @param plan description of where the columns are, which is part of the key
     * @param height number of the height in the columns
     * @param name name of the height, which is part of the key under which its assessments are kept
     */
    public void assess(
            SensorLayer layer,
            FieldProbe probe,
            FieldColumns columns,
            String plan,
            int height,
            String name,
            IntConsumer progress) {
        if (!isKept(probe)) {
            layer.assess(probe, columns, height, Optional.empty(), progress);
            return;
        }
        StoreKey key = key(KIND, probe, plan, name);
        SliceForm form = new SliceForm(columns, probe.courses().size());
        Optional<LayerSlice> former = store.orElseThrow().find(key, form);
        long start = System.nanoTime();
        boolean isNew = layer.assess(probe, columns, height, former, progress);
        if (isNew) {
            double seconds = NANO * (System.nanoTime() - start);
            store.orElseThrow().keep(() -> key, form, layer.slice(height, columns), seconds);
        }
    }

    private StoreKey key(String kind, FieldProbe probe, String plan, String name) {
        DroneSettings drone = probe.drone().settings();
        List<Object> parts = new ArrayList<>(List.of(
                world,
                meshHash(probe),
                probe.sensor(),
                probe.settings().getClass().getName(),
                CanonicalSettings.of((Record) probe.settings()),
                probe.drone().id(),
                CanonicalSettings.of(drone),
                StoreKey.hash(probe.drone().tree().mesh()),
                probe.seed(),
                probe.courses(),
                probe.terms(),
                probe.needed(),
                plan,
                name));
        return StoreKey.of(kind, List.of(), parts.toArray());
    }

    private String meshHash(FieldProbe probe) {
        if (hashed != probe.world().mesh()) {
            hashed = probe.world().mesh();
            hash = StoreKey.hash(probe.world().mesh());
        }
        return hash;
    }

    /** The form of a slice: ints columns and rows, doubles heights, then for each row ints entries and bytes. */
    private record SliceForm(FieldColumns columns, int courses) implements StoredForm<LayerSlice> {
        @Override
        public void write(LayerSlice value, StoreWriter target) throws IOException {
            target.addInt(value.columns());
            target.addInt(value.entries().length);
            target.addDoubles(value.z());
            for (int row = 0; row < value.entries().length; row++) {
                target.addInts(value.entries()[row]);
                target.addBytes(value.byCourse()[row]);
            }
        }

        @Override
        public LayerSlice read(StoreReader source) throws IOException {
            int across = source.nextInt();
            int rows = source.length(2 * Integer.BYTES);
            double[] z = source.nextDoubles();
            int[][] entries = new int[rows][];
            byte[][] byCourse = new byte[rows][];
            for (int row = 0; row < rows; row++) {
                entries[row] = source.nextInts();
                byCourse[row] = source.nextBytes();
            }
            LayerSlice slice = new LayerSlice(across, z, entries, byCourse);
            slice.check(columns.columns(), columns.rows(), courses);
            return slice;
        }
    }
}
