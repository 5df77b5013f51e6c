package org.dronewatch.app;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import me.tongfei.progressbar.ProgressBar;
import org.dronewatch.app.console.Notes;
import org.dronewatch.app.console.Progress;
import org.dronewatch.app.option.JsonOption;
import org.dronewatch.bench.KernelBench;
import org.dronewatch.bench.RayFile;
import org.dronewatch.bench.RayGenerator;
import org.dronewatch.bench.RaySet;
import org.dronewatch.bench.TracingSpeed;
import org.dronewatch.bench.TraversalKind;
import org.dronewatch.kdtree.KDTreeStats;
import org.dronewatch.mesh.io.LoadedModel;
import org.dronewatch.mesh.io.ModelLoader;
import org.dronewatch.parallel.Workers;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** Measures the ray kernel. */
@Command(
        name = "bench",
        mixinStandardHelpOptions = true,
        description = "Measures how many rays per second are traced in a model; prints one JSON line for each"
                + " set of rays, or, with --json, a single object.",
        footer = {"", "Example:", "  dronewatch bench models/hill.obj --passes 9"})
final class BenchCommand implements Callable<Integer> {

    @Parameters(index = "0", paramLabel = "MODEL.obj", description = "Model, in its own coordinates.")
    private String model;

    @Option(
            names = "--rays",
            paramLabel = "FILE",
            description =
                    "Rays to trace: int32 count, then six float32 per ray (origin, direction),"
                            + " little-endian. Without it, camera rays and diffusely reflected rays are generated from the seed.")
    private Path rays;

    @Option(
            names = "--width",
            paramLabel = "W",
            description = "Treats the rays of the file as an image of this width, stored row by row.")
    private Integer width;

    @Option(
            names = "--query",
            defaultValue = "nearest",
            paramLabel = "nearest|occluded",
            description = "nearest (the nearest triangle along each ray) or occluded (whether any triangle"
                    + " crosses the segment from a ray's origin to the tip of its direction vector, which need not have"
                    + " unit length); nearest by default.")
    private RaySet.Query query;

    @Option(names = "--passes", defaultValue = "5", paramLabel = "N", description = "Measured passes; 5 by default.")
    private int passes;

    @Option(names = "--threads", defaultValue = "1", paramLabel = "N", description = "Threads; 1 by default.")
    private int threads;

    @Option(
            names = "--traversal",
            defaultValue = "fastest",
            paramLabel = "NAME",
            description = "Traversal: tiles (rasteriser, for images), fan (for segments with a common origin), stack or"
                    + " sequential (one ray at a time through the kd-tree), or bvh; the fastest by default.")
    private TraversalKind traversal;

    @Option(
            names = "--hits",
            paramLabel = "FILE",
            description = "Writes the hits: float32 distance and int32 triangle for each ray.")
    private String hits;

    @Option(
            names = "--seed",
            defaultValue = "1",
            paramLabel = "N",
            description = "Seed of the generated rays; 1 by default.")
    private long seed;

    @Mixin
    private JsonOption json = new JsonOption();

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        check();
        WholeFile hitsFile = hits == null ? null : new WholeFile("--hits", hits);
        RaySet given = rays == null ? null : readRays();
        LoadedModel loaded = new ModelLoader(Path.of("")).loadAsWritten(model);
        Notes.of(spec).accept("read " + loaded.describe());
        KernelBench bench = new KernelBench(loaded.mesh(), traversal, threads);
        Notes.of(spec).accept(KDTreeStats.of(bench.tree()).toString());
        List<RaySet> sets = given == null ? madeRays(bench) : List.of(given);
        List<ObjectNode> lines = new ArrayList<>();
        for (RaySet set : sets) {
            ObjectNode line = measure(bench, set);
            lines.add(line);
            if (!json.isAsked()) {
                spec.commandLine().getOut().println(JsonMapper.shared().writeValueAsString(line));
            }
        }
        json.print(() -> toJson(lines), out -> {});
        if (hitsFile != null) {
            hitsFile.write(stream -> RayFile.writeHits(stream, bench.distances(), bench.sourceTriangles()));
        }
        return 0;
    }

    private void check() {
        require(passes >= 1 && passes <= 1000, "--passes " + passes + ": must be 1 to 1000");
        require(
                threads >= 1 && threads <= Workers.MAX_THREADS,
                "--threads " + threads + ": must be 1 to " + Workers.MAX_THREADS);
        require(hits == null || rays != null, "--hits needs --rays: hits are written only for the rays of a file");
        require(
                width == null || rays != null,
                "--width needs --rays: it specifies how the rays of a file form an image");
        require(
                query == RaySet.Query.NEAREST || rays != null,
                "--query occluded needs --rays: segments are not generated");
        require(
                query == RaySet.Query.NEAREST || hits == null && width == null,
                "--query occluded takes neither --hits nor --width: it does not determine which triangle blocks"
                        + " a segment");
        require(width == null || width >= 1, "--width " + width + ": must be 1 or more");
    }

    private static void require(boolean holds, String otherwise) {
        if (!holds) {
            throw new InputException(otherwise);
        }
    }

    private RaySet readRays() {
        RaySet set = new RaySet("file", RayFile.read(rays), width == null ? 0 : width, query);
        require(
                set.width() == 0 || set.count() % set.width() == 0,
                "--width " + width + ": does not divide the " + set.count() + " rays of " + rays + " into whole rows");
        return set;
    }

    private List<RaySet> madeRays(KernelBench bench) {
        RayGenerator generator = new RayGenerator(bench.tree(), seed);
        List<RaySet> sets = new ArrayList<>();
        sets.add(generator.camera());
        RaySet diffuse = generator.diffuse(sets.get(0));
        if (diffuse.count() > 0) {
            sets.add(diffuse);
        } else {
            Notes.of(spec).accept("no diffuse rays: the camera's rays do not hit this model");
        }
        return sets;
    }

    private ObjectNode toJson(List<ObjectNode> lines) {
        ObjectNode root = JsonMapper.shared().createObjectNode();
        root.put("model", model);
        root.putArray("sets").addAll(lines);
        return root;
    }

    private ObjectNode measure(KernelBench bench, RaySet set) {
        TracingSpeed measured;
        try (ProgressBar bar = Notes.areOff(spec) ? null : Progress.barOf(set.name(), 1 + passes)) {
            measured = bench.measure(set, passes, name -> {
                if (bar != null) {
                    bar.step();
                }
            });
        }
        ObjectNode line = JsonMapper.shared().createObjectNode();
        line.put("set", measured.set());
        line.put("rays", measured.rays());
        line.put("hits", measured.hits());
        line.put("mrays", rounded(measured.median()));
        line.put("mrays_min", rounded(measured.slowest()));
        line.put("mrays_max", rounded(measured.fastest()));
        line.put("build_s", rounded(bench.buildSeconds()));
        line.put("traversal", measured.traversal());
        line.put("threads", threads);
        if (rays == null) {
            line.put("seed", seed);
        }
        return line;
    }

    private static double rounded(double value) {
        return Math.rint(value * 1e4) / 1e4;
    }
}
