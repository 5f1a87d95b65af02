using System;

namespace Rabit.Vision;

/// <summary>Decodes the blocks of a scan into the samples of its components (ITU-T T.81, annex F.2).</summary>
internal sealed class JpegScan(JpegHeader header)
{
    private const int BlockSize = 8;

    private readonly int[] _block = new int[64];
    private readonly InverseDct _inverse = new();
    private bool _isBad;

    /// <summary>Decodes one scan; gives the place behind it.</summary>
    /// <exception cref="PictureException">The scan is damaged or cut off.</exception>
    public int Decode(byte[] data, int at, int end)
    {
        _isBad = false;
        var bits = new JpegBits(data, at, end);
        bool isSingle = header.ScanComponentCount == 1;
        JpegComponent first = header.ScanComponents[0];
        int across = isSingle ? header.BlocksAcross(first) : header.UnitsAcross;
        int down = isSingle ? header.BlocksDown(first) : header.UnitsDown;
        Reset();
        int untilRestart = header.RestartInterval;
        int restart = 0;
        for (int row = 0; row < down; row++)
        {
            for (int column = 0; column < across; column++)
            {
                if (header.RestartInterval > 0 && untilRestart-- == 0)
                {
                    Restart(ref bits, restart++);
                    untilRestart = header.RestartInterval - 1;
                }

                if (isSingle)
                    DecodeBlock(ref bits, first, column, row);
                else
                    DecodeUnit(ref bits, column, row);
                if (_isBad || bits.IsOverdrawn)
                    throw Fault(in bits, row, down);
            }
        }

        bits.FindMarker();
        return bits.At;
    }

    private PictureException Fault(in JpegBits bits, int row, int down)
    {
        string place = $"in row {row + 1} of {down} of its blocks";
        return header.Fault(
            bits.IsOverdrawn ? $"it is cut off {place}" : $"it is damaged {place}: such a code there is not");
    }

    private void Reset()
    {
        for (int at = 0; at < header.ScanComponentCount; at++)
            header.ScanComponents[at].Predictor = 0;
    }

    private void Restart(ref JpegBits bits, int number)
    {
        if (!bits.TryPassMarker(JpegMarker.FirstRestart + (number & 7)))
            throw header.Fault($"it is damaged: its restart marker {number + 1} is missing");
        Reset();
    }

    private void DecodeUnit(ref JpegBits bits, int column, int row)
    {
        for (int at = 0; at < header.ScanComponentCount; at++)
        {
            JpegComponent component = header.ScanComponents[at];
            for (int y = 0; y < component.Vertical; y++)
            {
                for (int x = 0; x < component.Horizontal; x++)
                    DecodeBlock(
                        ref bits, component, (column * component.Horizontal) + x, (row * component.Vertical) + y);
            }
        }
    }

    private void DecodeBlock(ref JpegBits bits, JpegComponent component, int column, int row)
    {
        int last = ReadCoefficients(ref bits, component);
        int at = (row * BlockSize * component.Stride) + (column * BlockSize);
        if (last == 0)
        {
            InverseDct.Fill(_block[0], component.Samples, at, component.Stride);
            _block[0] = 0;
            return;
        }

        _inverse.Transform(_block, component.Samples, at, component.Stride);
        Array.Clear(_block, 0, _block.Length);
    }

    // Gives the number of the last coefficient that is not 0, in the order of the file.
    private int ReadCoefficients(ref JpegBits bits, JpegComponent component)
    {
        int[] steps = header.Quantisation[component.QuantisationTable];
        int[] block = _block;
        component.Predictor += ReadDifference(ref bits, header.Huffman(false, component.DcTable));
        block[0] = component.Predictor * steps[0];

        HuffmanTable table = header.Huffman(true, component.AcTable);
        int[] entries = table.Entries;
        byte[] order = JpegTables.ZigZag;
        int last = 0;
        for (int at = 1; at < 64; at++)
        {
            if (bits.Count < 32)
                bits.Fill();
            int entry = entries[(int)(bits.Bits >> (64 - HuffmanTable.LookUpBits))];
            if (entry == 0)
                entry = table.FindLong((int)(bits.Bits >> 48));
            if (entry == HuffmanTable.BadCode)
            {
                _isBad = true;
                return last;
            }

            bits.Skip(HuffmanTable.LengthOf(entry));
            at += HuffmanTable.RunOf(entry);
            int size = HuffmanTable.SizeOf(entry);
            int value = HuffmanTable.ValueOf(entry);
            if (size > 0)
            {
                value = HuffmanTable.Extend((int)(bits.Bits >> (64 - size)), size);
                bits.Skip(size);
            }
            else if (value == 0)
            {
                // The end of the block, or sixteen zeros.
                if (HuffmanTable.RunOf(entry) != 15)
                    break;
                continue;
            }

            // Some encoders run over the end of a block; libjpeg makes the last coefficient of it.
            at = Math.Min(at, 63);

            block[order[at]] = value * steps[at];
            last = at;
        }

        return last;
    }

    private int ReadDifference(ref JpegBits bits, HuffmanTable table)
    {
        if (bits.Count < 32)
            bits.Fill();
        int entry = table.Entries[(int)(bits.Bits >> (64 - HuffmanTable.LookUpBits))];
        if (entry == 0)
            entry = table.FindLong((int)(bits.Bits >> 48));
        if (entry == HuffmanTable.BadCode)
        {
            _isBad = true;
            return 0;
        }

        bits.Skip(HuffmanTable.LengthOf(entry));
        int size = HuffmanTable.SizeOf(entry);
        if (size == 0)
            return HuffmanTable.ValueOf(entry);
        int difference = HuffmanTable.Extend((int)(bits.Bits >> (64 - size)), size);
        bits.Skip(size);
        return difference;
    }
}
