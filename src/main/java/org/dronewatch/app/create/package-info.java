/** The scene that the command new writes, with the files of its site. */
package org.dronewatch.app.create;
