package org.dronewatch.spark;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.apache.spark.TaskContext;
import org.apache.spark.api.plugin.DriverPlugin;
import org.apache.spark.api.plugin.ExecutorPlugin;
import org.apache.spark.api.plugin.PluginContext;
import org.apache.spark.api.plugin.SparkPlugin;

/** Halts the first executor that is in the middle of its second task, as if its machine had lost power. */
public final class HaltOnce implements SparkPlugin {
    /** The file that is made when it happens. */
    static final String MARKER = "spark.test.halted";

    private static final long AMID_MILLIS = 30;

    @Override
    public DriverPlugin driverPlugin() {
        return null;
    }

    @Override
    public ExecutorPlugin executorPlugin() {
        return new Executor();
    }

    private static final class Executor implements ExecutorPlugin {
        private Path marker;
        private int tasks;

        @Override
        public void init(PluginContext context, Map<String, String> settings) {
            marker = Path.of(context.conf().get(MARKER));
        }

        @Override
        public void onTaskStart() {
            tasks++;
            if (tasks > 1 && !Files.exists(marker)) {
                TaskContext task = TaskContext.get();
                Thread thread = new Thread(() -> haltAmid(task));
                thread.setDaemon(true);
                thread.start();
            }
        }

        private void haltAmid(TaskContext task) {
            try {
                Thread.sleep(AMID_MILLIS);
                if (!task.isCompleted()) {
                    Files.createFile(marker);
                    Runtime.getRuntime().halt(1);
                }
            } catch (FileAlreadyExistsException e) {
                // Another executor was first.
                return;
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }
    }
}
