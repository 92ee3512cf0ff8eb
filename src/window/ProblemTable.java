package window;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;

import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.TableColumn;

import arguments.Messages;
import diagnostics.Problem;

/** Lists the errors and warnings of a scene with file, line and column. It is hidden while there are none. */
final class ProblemTable extends JPanel {

  private static final long serialVersionUID = 1L;

  private static final String[] COLUMNS = {"kind", "file", "line", "column", "message"};
  private static final int[] WIDTHS = {70, 160, 60, 80, 800};

  private static final int HEADER_MARGIN = 4;

  private static final class Rows extends AbstractTableModel {

    private static final long serialVersionUID = 1L;

    private transient List<Problem> problems = new ArrayList<>();

    @Override
    public int getRowCount() {
      return problems.size();
    }

    @Override
    public int getColumnCount() {
      return COLUMNS.length;
    }

    @Override
    public String getColumnName(final int column) {
      return Messages.text("window.problems." + COLUMNS[column]);
    }

    @Override
    public Object getValueAt(final int row, final int column) {
      final Problem problem = problems.get(row);
      return switch (column) {
        case 0 -> Messages.text("window.problems." + problem.severity());
        case 1 -> problem.file().replaceFirst(".*[/\\\\]", "");
        case 2 -> problem.line() == 0 ? "" : problem.line();
        case 3 -> problem.column() == 0 ? "" : problem.column();
        default -> problem.message();
      };
    }
  }

  private final Rows rows = new Rows();
  private final JTable table = new JTable(rows) {
    private static final long serialVersionUID = 1L;

    /** The whole problem, with the path of its file. */
    @Override
    public String getToolTipText(final java.awt.event.MouseEvent event) {
      final int row = rowAtPoint(event.getPoint());
      return row < 0 ? null : rows.problems.get(row).toString();
    }
  };

  ProblemTable() {
    super(new BorderLayout());
    table.setName("problems");
    table.getAccessibleContext().setAccessibleName(Messages.text("window.problems.name"));
    table.setFillsViewportHeight(true);
    for (int i = 0; i < WIDTHS.length; i++) {
      final TableColumn column = table.getColumnModel().getColumn(i);
      column.setPreferredWidth(WIDTHS[i]);
      column.setMinWidth(headerWidth(i));
    }
    table.getColumnModel().getColumn(WIDTHS.length - 1).setCellRenderer(new WrappedText());
    add(new JScrollPane(table));
    setPreferredSize(new Dimension(600, 120));
    setVisible(false);
  }

  private int headerWidth(final int column) {
    final Component header = table.getTableHeader().getDefaultRenderer().getTableCellRendererComponent(table,
        table.getColumnName(column), false, false, -1, column);
    return header.getPreferredSize().width + HEADER_MARGIN;
  }

  void show(final List<Problem> problems) {
    rows.problems = List.copyOf(problems);
    rows.fireTableDataChanged();
    setVisible(!problems.isEmpty());
    if (getParent() != null) {
      getParent().revalidate();
    }
  }

  JTable table() {
    return table;
  }
}
