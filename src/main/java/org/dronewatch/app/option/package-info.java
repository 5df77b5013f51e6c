/** The options that several commands have, and the scene that a command is about. */
package org.dronewatch.app.option;
