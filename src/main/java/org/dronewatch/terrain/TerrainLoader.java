package org.dronewatch.terrain;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import org.dronewatch.geo.MapPoint;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.parallel.LongTask;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.terrain.io.ElevationFile;
import org.dronewatch.terrain.io.ElevationFiles;
import org.dronewatch.terrain.io.Window;

/**
 * Converts elevation files to triangles in the world frame: it reads the posts near the origin, thins them out as far
 * as the accuracy allows, and transforms the rest to the world frame in double precision. Immutable.
 */
public final class TerrainLoader {
    /** Reading more takes seconds. */
    private static final long LONG = 3_000_000;

    private final Path directory;
    private final Consumer<String> progress;

    /**
     * A loader of files by name.
     *
     * @param directory directory against which relative paths are resolved
     * @param progress receives a line before each step that takes seconds
     */
    public TerrainLoader(Path directory, Consumer<String> progress) {
        this.directory = directory;
        this.progress = progress;
    }

    /**
     * Reads a terrain.
     *
     * @param settings settings that name at least one file
     * @param origin origin of the world frame; if its height is not known, z is the height that the files state
     * @throws InputException with a one-line message when a file is missing, damaged or in no known format, has no
     *     posts near the origin or too many, or does not match the others
     * @throws java.util.concurrent.CancellationException when the thread is interrupted
     */
    public LoadedTerrain load(TerrainSettings settings, Origin origin) {
        ElevationFiles source = new ElevationFiles(directory);
        List<ElevationFile> files = new ArrayList<>();
        List<FileHash> hashes = new ArrayList<>();
        for (String name : settings.allFiles()) {
            files.add(source.open(name));
            hashes.add(source.hash(name));
        }
        if (files.isEmpty()) {
            throw new InputException("needs a 'file' of elevations, or several 'files'");
        }
        Mosaic mosaic = new Mosaic(files, settings, origin);
        Window window = mosaic.window();
        float[] raw = read(mosaic, window.posts());
        Heights heights = new Heights(raw, settings.nodata());
        Grid grid = Grid.southward(mosaic.lattice(), window.columns(), window.rows(), raw, mosaic.map());
        double level = heightAt(grid, mosaic, raw, settings.verticalOffset());
        Posts posts = grid.posts(mosaic.map(), settings.verticalOffset());
        int all = PostTriangles.countAll(posts);
        if (all == 0) {
            throw new InputException(files.get(0).name() + ": none of its " + window.posts() + " posts within "
                    + settings.radius() + " m of the origin forms a triangle with others that have heights");
        }
        PostTriangles kept = thinned(posts, settings.accuracy());
        List<String> warnings = new ArrayList<>();
        heights.warn(warnings, settings.nodata().isPresent() || files.stream().allMatch(ElevationFile::statesNodata));
        TerrainReport report = new TerrainReport(settings, mosaic, files);
        report.warn(warnings, level);
        return new LoadedTerrain(
                mesh(posts, kept, settings.material()),
                heights.known(),
                heights.holes(),
                all,
                kept.error(),
                hashes,
                report.lines(posts, heights, all, kept, level, origin),
                warnings);
    }

    private float[] read(Mosaic mosaic, long posts) {
        String what = String.format(Locale.ROOT, "terrain: reading %,d posts", posts);
        try (LongTask task = LongTask.begin(what, posts, posts > LONG, progress)) {
            float[] heights = mosaic.heights();
            task.advance(posts);
            return heights;
        }
    }

    private PostTriangles thinned(Posts posts, double accuracy) {
        long count = (long) posts.columns() * posts.rows();
        String what = String.format(Locale.ROOT, "terrain: thinning out %,d posts", count);
        // How many are kept is known only at the end.
        try (LongTask task = LongTask.begin(what, -1, accuracy > 0.0 && count > LONG, progress)) {
            return Decimation.of(posts, accuracy, task);
        }
    }

    /** The height of the post nearest to the origin, m; NaN where there is none. */
    private static double heightAt(Grid grid, Mosaic mosaic, float[] heights, double offset) {
        MapPoint origin = mosaic.map().onMap(new Position(0, 0, 0));
        long column = Math.round(grid.lattice().columnAt(origin.x(), origin.y()));
        long row = Math.round(grid.lattice().rowAt(origin.x(), origin.y()));
        boolean isInside = column >= 0 && column < grid.columns() && row >= 0 && row < grid.rows();
        return isInside ? heights[(int) (row * grid.columns() + column)] + offset : Double.NaN;
    }

    private static TriangleMesh mesh(Posts posts, PostTriangles kept, String material) {
        int[] numbers = new int[posts.columns() * posts.rows()];
        int[] corners = new int[kept.corners().length];
        for (int post : kept.corners()) {
            numbers[post] = 1;
        }
        int count = 0;
        for (int post = 0; post < numbers.length; post++) {
            numbers[post] = numbers[post] == 0 ? -1 : count++;
        }
        float[] vertices = new float[3 * count];
        PostFrame.Row frame = posts.frame().newRow();
        for (int post = 0; post < numbers.length; post++) {
            if (numbers[post] >= 0) {
                frame.to(post / posts.columns());
                frame.column(post % posts.columns());
                vertices[3 * numbers[post]] = (float) frame.east(posts.up(post));
                vertices[3 * numbers[post] + 1] = (float) frame.north(posts.up(post));
                vertices[3 * numbers[post] + 2] = posts.up(post);
            }
        }
        int[] sources = new int[kept.count()];
        for (int i = 0; i < kept.count(); i++) {
            // The order changes from clockwise to counter-clockwise.
            corners[3 * i] = numbers[kept.corners()[3 * i]];
            corners[3 * i + 1] = numbers[kept.corners()[3 * i + 2]];
            corners[3 * i + 2] = numbers[kept.corners()[3 * i + 1]];
            sources[i] = i;
        }
        return new TriangleMesh(vertices, corners, new int[kept.count()], sources, List.of(material));
    }
}
