/** The scene that the {@code new} command writes, with the files of its site. */
package org.dronewatch.app.create;
