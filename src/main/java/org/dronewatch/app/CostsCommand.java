package org.dronewatch.app;

import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.dronewatch.app.console.Notes;
import org.dronewatch.app.option.PathWord;
import org.dronewatch.app.option.ThreadsOption;
import org.dronewatch.bench.CostStudy;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelLoader;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.report.CostReport;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Measures how costs grow on this machine. */
@Command(
        name = "costs",
        mixinStandardHelpOptions = true,
        description = "Measures on this machine how time and memory depend on the numbers of triangles, rays, sensors,"
                + " drones and threads; writes tables and plots. Takes about three minutes.",
        footer = {"", "Example:", "  dronewatch costs --out target/costs"})
final class CostsCommand implements Callable<Integer> {
    private static final int LEAST = 1000;
    private static final int MOST = 20_000_000;

    @Option(
            names = "--out",
            defaultValue = "target/costs",
            paramLabel = "DIR",
            description = "Directory for tables and plots; target/costs by default.")
    private String out;

    @Option(
            names = "--largest",
            defaultValue = "2000000",
            paramLabel = "N",
            description = "Number of triangles of the largest terrain, 1000 to 20000000; 2000000 by default.")
    private int largest;

    @Option(
            names = "--drone",
            defaultValue = "packaged:quadrotor.obj",
            paramLabel = "FILE.obj",
            description = "The drone's model; the packaged quadrotor by default.")
    private String drone;

    @Mixin
    private ThreadsOption threads = new ThreadsOption();

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        if (largest < LEAST || largest > MOST) {
            throw new InputException("--largest " + largest + ": must be " + LEAST + " to " + MOST);
        }
        threads.number();
        TriangleMesh mesh =
                new ModelLoader(Path.of("")).load(ModelSettings.of(drone)).mesh();
        CostStudy study = new CostStudy(mesh, largest, next -> Notes.of(spec).accept("measuring " + next));
        CostReport.write(PathWord.of("--out", out), () -> threads.call(study::run));
        spec.commandLine().getOut().println("tables and plots in " + out);
        return 0;
    }
}
