/** The options that several commands share, and the scene that a command is about. */
package org.dronewatch.app.option;
