package window;

import java.awt.Component;

import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.table.TableCellRenderer;

/** A table cell that wraps its text and adjusts the height of its row. */
final class WrappedText extends JTextArea implements TableCellRenderer {

  private static final long serialVersionUID = 1L;

  WrappedText() {
    setLineWrap(true);
    setWrapStyleWord(true);
  }

  @Override
  public Component getTableCellRendererComponent(final JTable table, final Object value, final boolean isSelected,
      final boolean hasFocus, final int row, final int column) {
    setText(String.valueOf(value));
    setFont(table.getFont());
    setBackground(isSelected ? table.getSelectionBackground() : table.getBackground());
    setForeground(isSelected ? table.getSelectionForeground() : table.getForeground());
    setSize(table.getColumnModel().getColumn(column).getWidth(), 1);
    final int height = Math.max(getPreferredSize().height, table.getRowHeight());
    if (table.getRowHeight(row) != height) {
      table.setRowHeight(row, height);
    }
    return this;
  }
}
