package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.Writer;
import org.dronewatch.run.store.StorePlace;
import org.dronewatch.scene.Scene;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What {@code --no-cache} does, and that it does so for one command only. */
class NoCacheTest {
    private static String seen;

    private String before;

    /** Finds out whether the store is off while a command describes it. */
    public static final class Watching extends Scene {
        private static final long serialVersionUID = 1L;

        @Override
        protected void build() {
            seen = System.getProperty(StorePlace.PROPERTY);
            loadWorld(loadPackaged("hill.obj"));
        }
    }

    @BeforeEach
    void rememberPlace() {
        before = System.getProperty(StorePlace.PROPERTY);
        System.setProperty(StorePlace.PROPERTY, "/somewhere");
    }

    @AfterEach
    void restorePlace() {
        if (before == null) {
            System.clearProperty(StorePlace.PROPERTY);
        } else {
            System.setProperty(StorePlace.PROPERTY, before);
        }
    }

    private static void check(String... options) {
        String[] arguments = new String[options.length + 2];
        arguments[0] = "check";
        arguments[1] = Watching.class.getName();
        System.arraycopy(options, 0, arguments, 2, options.length);
        StringWriter err = new StringWriter();
        int code = Main.execute(new PrintWriter(Writer.nullWriter()), new PrintWriter(err), arguments);
        assertThat(code).as(err.toString()).isZero();
    }

    @Test
    void theStoreIsOffForOneCommand() {
        check("--no-cache");
        assertThat(seen).isEqualTo(StorePlace.OFF);
        assertThat(System.getProperty(StorePlace.PROPERTY)).isEqualTo("/somewhere");

        check();
        assertThat(seen).isEqualTo("/somewhere");
    }
}
