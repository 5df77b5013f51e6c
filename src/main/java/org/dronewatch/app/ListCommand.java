package org.dronewatch.app;

import java.util.concurrent.Callable;
import org.dronewatch.scenes.PackagedScene;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** Lists what comes with the program. */
@Command(name = "list", mixinStandardHelpOptions = true, description = "Lists the packaged scenes, a line each.")
final class ListCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        for (PackagedScene scene : PackagedScene.all()) {
            spec.commandLine().getOut().printf("scene  %-16s %s%n", scene.name(), scene.summary());
        }
        return 0;
    }
}
