namespace Rabit.Vision;

/// <summary>Orders arrays in place without an allocation, which the runtime's own sort has on Mono.</summary>
internal static class InPlaceOrder
{
    /// <summary>The value that would be at an index if the first ones were sorted; they are reordered.</summary>
    public static ushort Nth(ushort[] values, int count, int index)
    {
        (int left, int right) = (0, count - 1);
        while (left < right)
        {
            ushort pivot = values[(left + right) / 2];
            (int low, int high) = (left, right);
            while (low <= high)
            {
                while (values[low] < pivot)
                    low++;
                while (values[high] > pivot)
                    high--;
                if (low > high)
                    break;
                (values[low], values[high]) = (values[high], values[low]);
                low++;
                high--;
            }

            if (index <= high)
                right = high;
            else if (index >= low)
                left = low;
            else
                break;
        }

        return values[index];
    }

    /// <summary>
    /// Sorts indices by their values, the largest first: a heap (of equal ones any order, but the same).
    /// </summary>
    public static void SortDescending(float[] values, int[] indices, int count)
    {
        for (int root = (count / 2) - 1; root >= 0; root--)
            SiftDown(values, indices, root, count);
        for (int end = count - 1; end > 0; end--)
        {
            Swap(values, indices, 0, end);
            SiftDown(values, indices, 0, end);
        }
    }

    // The smallest is at the root.
    private static void SiftDown(float[] values, int[] indices, int root, int count)
    {
        while ((2 * root) + 1 < count)
        {
            int child = (2 * root) + 1;
            if (child + 1 < count && values[child + 1] < values[child])
                child++;
            if (values[root] <= values[child])
                return;
            Swap(values, indices, root, child);
            root = child;
        }
    }

    private static void Swap(float[] values, int[] indices, int a, int b)
    {
        (values[a], values[b]) = (values[b], values[a]);
        (indices[a], indices[b]) = (indices[b], indices[a]);
    }
}
