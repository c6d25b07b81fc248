using System;
using System.Threading;
using System.Threading.Tasks;

namespace Glint.Core
{
    /// <summary>Parallel loops in blocks.</summary>
    static class Blocks
    {
        /// <summary>Elements of a block.</summary>
        public const int Size = 8192;

        /// <summary>
        /// Calls <paramref name="action"/> with the first and the end of each block of 0 .. count - 1.
        /// The result must not depend on the blocks' order.
        /// </summary>
        /// <exception cref="OperationCanceledException">Cancelled; some blocks were not processed.</exception>
        public static void For(int count, Action<int, int> action, CancellationToken cancel = default)
        {
            cancel.ThrowIfCancellationRequested();
            int blocks = (int)(((long)count + Size - 1) / Size);
            if (blocks <= 1)
                action(0, count);
            else
                Parallel.For(0, blocks, new ParallelOptions { CancellationToken = cancel },
                    block => action(block * Size, (int)Math.Min(count, (block + 1L) * Size)));
        }
    }
}
