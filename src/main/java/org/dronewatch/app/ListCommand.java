package org.dronewatch.app;

import java.io.PrintWriter;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.dronewatch.app.option.JsonOption;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.CatalogEntry;
import org.dronewatch.catalog.CatalogTexts;
import org.dronewatch.catalog.Positioners;
import org.dronewatch.catalog.SensorSystem;
import org.dronewatch.mesh.io.MeshReaders;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.setting.Choices;
import org.dronewatch.setting.FoundKind;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Kind;
import org.dronewatch.setting.KindRegistry;
import org.dronewatch.setting.PlainText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Lists what comes with the program. */
@Command(
        name = "list",
        mixinStandardHelpOptions = true,
        description =
                "Lists the packaged scenes and the catalogue's sensors, systems and positioners, one per line; or the"
                        + " kinds of sensor, flight and model that a scene can use; or one entry of the catalogue with its"
                        + " source and its assumptions.",
        footer = {"", "Examples:", "  dronewatch list spotterrf-c550", "  dronewatch list --json"})
final class ListCommand implements Callable<Integer> {
    private static final String KIND_LINE = "%-19s %-19s %s; %s%n";

    @Option(
            names = "--kinds",
            description =
                    "Lists the kinds of sensors, flights and other things that scene files choose by 'kind: NAME', with"
                            + " their origin on the class path.")
    private boolean kinds;

    @Parameters(
            arity = "0..1",
            paramLabel = "NAME",
            description =
                    "Prints this sensor, system or positioner as it is written in the catalogue: source, assumptions,"
                            + " ranges and settings.")
    private String name;

    @Mixin
    private JsonOption json = new JsonOption();

    @Override
    public Integer call() {
        if (name != null) {
            if (kinds) {
                throw new InputException("--kinds lists all kinds: leave out " + PlainText.value(name));
            }
            json.print(() -> CatalogueJson.entry(name), out -> {
                out.print(CatalogTexts.of(name));
                out.flush();
            });
        } else if (kinds) {
            json.print(CatalogueJson::kinds, out -> {
                listKinds(out);
                listReaders(out);
            });
        } else {
            json.print(CatalogueJson::all, ListCommand::listAll);
        }
        return 0;
    }

    private static void listAll(PrintWriter out) {
        for (PackagedScene scene : PackagedScene.all()) {
            out.printf("scene      %-22s %s%n", scene.name(), scene.summary());
        }
        for (String name : Catalog.packagedNames()) {
            CatalogEntry entry = Catalog.packaged().entry(name).orElseThrow();
            out.printf(
                    "%-10s %-22s %s; range %s; covers %s; basis: %s%s%n",
                    entry.kind(),
                    name,
                    entry.title(),
                    ranges(entry),
                    entry.coverage(),
                    entry.basis().name().toLowerCase(Locale.ROOT),
                    entry.price().map(price -> "; " + price).orElse(""));
        }
        for (String name : Catalog.systemNames()) {
            SensorSystem system = Catalog.system(name).orElseThrow();
            String parts = system.sensors().entrySet().stream()
                    .map(part ->
                            part.getKey() + " " + part.getValue().text("use").orElse(""))
                    .collect(Collectors.joining(", "));
            out.printf("%-10s %-22s %s: %s%n", "system", name, system.title(), parts);
        }
        for (String name : Positioners.packagedNames()) {
            CatalogEntry entry = new Positioners().entry(name).orElseThrow();
            out.printf("%-10s %-22s %s; covers %s%n", "positioner", name, entry.title(), entry.coverage());
        }
    }

    private static void listKinds(PrintWriter out) {
        for (FoundKind found : KindRegistry.found().all()) {
            Kind<?> kind = found.kind();
            out.printf(
                    KIND_LINE, typeInWords(kind.type()), kind.name(), PlainText.value(kind.summary()), found.origin());
        }
    }

    private static void listReaders(PrintWriter out) {
        MeshReaders.found()
                .byExtension()
                .forEach((extension, reader) -> out.printf(
                        KIND_LINE,
                        "model file",
                        "." + extension,
                        PlainText.value(reader.summary()),
                        FoundKind.originOf(reader.getClass())));
    }

    /** The name of a type in words: "sensor" for {@code SensorSettings}. */
    static String typeInWords(Class<?> type) {
        return Choices.name(type.getSimpleName().replaceFirst("Settings$", "")).replace('-', ' ');
    }

    private static String ranges(CatalogEntry entry) {
        return entry.ranges().isEmpty()
                ? "not published"
                : entry.ranges().stream()
                        .map(range -> String.format(Locale.ROOT, "%.0f m (%s)", range.distance(), range.target()))
                        .collect(Collectors.joining(", "));
    }
}
