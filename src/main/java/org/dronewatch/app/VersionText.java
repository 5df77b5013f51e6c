package org.dronewatch.app;

import org.dronewatch.parallel.VectorInstructions;
import org.dronewatch.report.provenance.ProgramVersion;
import org.dronewatch.setting.PlainText;
import picocli.CommandLine.IVersionProvider;

/**
 * The text that {@code --version} prints: the program, the Java that runs it, and whether vector instructions are used.
 */
final class VersionText implements IVersionProvider {
    @Override
    public String[] getVersion() {
        return new String[] {
            ProgramVersion.PROGRAM + " " + ProgramVersion.text(),
            PlainText.line("Java " + property("java.runtime.version") + " (" + property("java.vendor") + "), "
                    + property("os.name") + " " + property("os.arch")),
            "vector instructions: " + VectorInstructions.inWords()
        };
    }

    private static String property(String name) {
        return System.getProperty(name, "unknown");
    }
}
