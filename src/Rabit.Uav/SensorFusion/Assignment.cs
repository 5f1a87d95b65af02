using System;

namespace Rabit.Uav.SensorFusion;

/// <summary>
/// Pairs rows with columns at the least total cost, by shortest augmenting paths (Jonker, Volgenant, Computing 38,
/// 1987): rows cubed. A row that finds no column worth it goes without, for a price. The room it works in is kept.
/// </summary>
internal sealed class Assignment
{
    // All arrays from 1, as the algorithm is written: 0 stands for none.
    private double[] _cost = [];
    private double[] _rowPrice = [];
    private double[] _columnPrice = [];
    private double[] _shortest = [];
    private int[] _rowOf = [];
    private int[] _cameFrom = [];
    private bool[] _isDone = [];
    private int[] _result = [];
    private int _columns;
    private double _missCost;

    /// <summary>Begins with all pairs forbidden.</summary>
    /// <param name="rows">How many rows.</param>
    /// <param name="columns">How many columns.</param>
    /// <param name="missCost">What a row without a column costs.</param>
    public void Begin(int rows, int columns, double missCost)
    {
        Reserve(rows, columns);
        Rows = rows;
        _columns = columns;
        _missCost = missCost;
        for (int i = 0; i < rows * columns; i++)
            _cost[i] = double.PositiveInfinity;
    }

    /// <summary>Makes room for so many, so that nothing is allocated later on.</summary>
    public void Reserve(int rows, int columns)
    {
        if (_cost.Length < rows * columns)
            _cost = new double[rows * columns];
        if (_rowPrice.Length <= rows)
            (_rowPrice, _result) = (new double[rows + 1], new int[rows + 1]);
        int all = columns + rows + 1;
        if (_columnPrice.Length < all)
            (_columnPrice, _shortest, _rowOf, _cameFrom, _isDone) =
                (new double[all], new double[all], new int[all], new int[all], new bool[all]);
    }

    /// <summary>How many rows there are.</summary>
    public int Rows { get; private set; }

    /// <summary>Allows a pair.</summary>
    public void Allow(int row, int column, double cost) => _cost[(row * _columns) + column] = cost;

    /// <summary>The column of a row after <see cref="Solve"/>; -1 for none.</summary>
    public int ColumnOf(int row) => _result[row];

    /// <summary>Finds the cheapest pairing.</summary>
    public void Solve()
    {
        int all = _columns + Rows;
        Array.Clear(_rowPrice, 0, Rows + 1);
        Array.Clear(_columnPrice, 0, all + 1);
        Array.Clear(_rowOf, 0, all + 1);
        for (int row = 1; row <= Rows; row++)
            Augment(row, all);
        for (int row = 0; row < Rows; row++)
            _result[row] = -1;
        for (int column = 1; column <= _columns; column++)
        {
            if (_rowOf[column] > 0)
                _result[_rowOf[column] - 1] = column - 1;
        }
    }

    // Columns behind the real ones stand for going without: each row has its own.
    private double CostOf(int row, int column)
    {
        if (column <= _columns)
            return _cost[((row - 1) * _columns) + column - 1];
        return column - _columns == row ? _missCost : double.PositiveInfinity;
    }

    private void Augment(int row, int all)
    {
        for (int column = 0; column <= all; column++)
            (_shortest[column], _isDone[column]) = (double.PositiveInfinity, false);
        _rowOf[0] = row;
        int at = 0;
        do
        {
            _isDone[at] = true;
            at = Step(at, all);
        }
        while (_rowOf[at] != 0);

        while (at != 0)
        {
            int before = _cameFrom[at];
            _rowOf[at] = _rowOf[before];
            at = before;
        }
    }

    // There is always a way on: the row's own way of going without.
    private int Step(int at, int all)
    {
        int row = _rowOf[at];
        double least = double.PositiveInfinity;
        int next = 0;
        for (int column = 1; column <= all; column++)
        {
            if (_isDone[column])
                continue;
            double length = CostOf(row, column) - _rowPrice[row] - _columnPrice[column];
            if (length < _shortest[column])
                (_shortest[column], _cameFrom[column]) = (length, at);
            if (_shortest[column] < least)
                (least, next) = (_shortest[column], column);
        }

        for (int column = 0; column <= all; column++)
        {
            if (_isDone[column])
            {
                _rowPrice[_rowOf[column]] += least;
                _columnPrice[column] -= least;
            }
            else
            {
                _shortest[column] -= least;
            }
        }

        return next;
    }
}
