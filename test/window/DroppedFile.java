package window;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.nio.file.Path;
import java.util.List;

/** A file as it comes from a file manager. */
record DroppedFile(Path file) implements Transferable {

  @Override
  public DataFlavor[] getTransferDataFlavors() {
    return new DataFlavor[] {DataFlavor.javaFileListFlavor};
  }

  @Override
  public boolean isDataFlavorSupported(final DataFlavor flavor) {
    return DataFlavor.javaFileListFlavor.equals(flavor);
  }

  @Override
  public Object getTransferData(final DataFlavor flavor) {
    return List.of(file.toFile());
  }
}
